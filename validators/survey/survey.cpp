#include "validators/survey/survey.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "validators/survey/chain_proof.hpp"
#include "validators/survey/flight_proof.hpp"
#include "validators/survey/ramp_proof.hpp"
#include "validators/survey/word_proof.hpp"

namespace mapwright::validators {
namespace {

// What a walk over an obstacle's segments shows.
struct Look {
  Box box = kEmptyBox;
  double least_height_m = HUGE_VAL, greatest_height_m = -HUGE_VAL;
  bool all_have_length = true;
  bool is_joined = true;
  bool has_one_side = true;  // indoor or outdoor
};

Look look_at(std::span<const Segment> segments) {
  Look look;
  Point end = segments.front().a;
  const InOut side = segments.front().in_out;
  for (const Segment& segment : segments) {
    look.box.add(segment.a);
    look.box.add(segment.b);
    look.least_height_m = std::min(look.least_height_m, segment.height_m);
    look.greatest_height_m = std::max(look.greatest_height_m, segment.height_m);
    look.all_have_length &= segment.a != segment.b;
    look.is_joined &= segment.a == end;
    look.has_one_side &= segment.in_out == side;
    end = segment.b;
  }
  return look;
}

double farthest(const Box& box) {
  return std::max(
      {std::abs(box.min_x), std::abs(box.min_y), std::abs(box.max_x), std::abs(box.max_y)});
}

bool comes_near(const Segment& segment, Point p, double reach_m) {
  return std::min(segment.a.x, segment.b.x) <= p.x + reach_m &&
         std::max(segment.a.x, segment.b.x) >= p.x - reach_m &&
         std::min(segment.a.y, segment.b.y) <= p.y + reach_m &&
         std::max(segment.a.y, segment.b.y) >= p.y - reach_m;
}

// By boxes: an end and the segments that are not its own nor the one beside it.
bool ends_may_come_near(std::span<const Segment> segments, double reach_m) {
  const std::size_t n = segments.size();
  for (std::size_t k = 2; k < n; ++k) {
    if (comes_near(segments[k], segments.front().a, reach_m) ||
        comes_near(segments[n - 1 - k], segments.back().b, reach_m)) {
      return true;
    }
  }
  return false;
}

bool stands_by_itself(ShapeType type) {
  return type != ShapeType::kStairs && type != ShapeType::kRamp;
}

}  // namespace

class Survey::Surveyor {
 public:
  Surveyor(Survey& survey, const Map& map, const ValidationOptions& options)
      : survey_(survey),
        obstacles_(map.obstacles),
        options_(options),
        chains_(options.sliver_width_m) {}

  void look() {
    survey_.boxes_.reserve(obstacles_.size());
    for (i_ = 0; i_ < obstacles_.size(); ++i_) look_at_obstacle(obstacles_[i_]);
    if (names_.may_repeat()) survey_.names_may_repeat_ = true;
  }

 private:
  void doubt(Doubt doubt) {
    survey_.in_doubt_[static_cast<std::size_t>(doubt)].push_back(static_cast<std::uint32_t>(i_));
  }
  void doubt_if(bool condition, Doubt which) {
    if (condition) doubt(which);
  }

  void look_at_obstacle(const Obstacle& obstacle) {
    doubt_if(obstacle.id < 0, Doubt::kNegativeId);
    if (i_ > 0 && obstacle.id <= obstacles_[i_ - 1].id) survey_.ids_may_repeat_ = true;
    look_at_words(obstacle);
    if (obstacle.segments.empty()) {
      survey_.boxes_.push_back(kEmptyBox);
      for (const Doubt each : {Doubt::kEmpty, Doubt::kChain, Doubt::kLow}) doubt(each);
      return;
    }
    const Look look = validators::look_at(obstacle.segments);
    add_box(look.box);
    look_at_attributes(obstacle, look);
    look_at_shape(obstacle, look);
  }

  void add_box(const Box& box) {
    survey_.boxes_.push_back(box);
    survey_.extent_.add({box.min_x, box.min_y});
    survey_.extent_.add({box.max_x, box.max_y});
    doubt_if(!(farthest(box) <= options_.max_coordinate_m), Doubt::kCoordinates);
  }

  void look_at_words(const Obstacle& obstacle) {
    const Words words = provers_.words_of(obstacle.semantic);
    bool are_sound = words.are_sound;
    const char* last = nullptr;
    for (const Segment& segment : obstacle.segments) {
      const char* const text = segment.semantic.view().data();
      if (text != last) are_sound = are_sound && provers_.are_sound(segment.semantic);
      last = text;
    }
    doubt_if(!are_sound, Doubt::kWords);
    doubt_if(words.have_outer, Doubt::kInnerRing);
    has_outer_ = words.have_outer;
    if (words.have_name && !is_part_of_the_one_before(obstacle)) look_at_name(words);
  }

  bool is_part_of_the_one_before(const Obstacle& obstacle) const {
    return i_ > 0 && obstacle.semantic == obstacles_[i_ - 1].semantic;
  }

  void look_at_name(const Words& words) {
    if (!words.are_sound) survey_.names_may_repeat_ = true;
    if (!words.have_outer) names_.add(words.name, words.level);
  }

  void look_at_attributes(const Obstacle& obstacle, const Look& look) {
    const double greatest_m = look.greatest_height_m;
    doubt_if(!(look.least_height_m >= 0.0 && greatest_m <= options_.max_height_m), Doubt::kHeights);
    doubt_if(!look.has_one_side, Doubt::kMixedInOut);
    if (!stands_by_itself(obstacle.shape_type)) return;
    doubt_if(!(greatest_m > std::max(options_.laser_height_m, 0.0)), Doubt::kLow);
    doubt_if(!(greatest_m <= options_.suspect_height_m), Doubt::kHigh);
  }

  void look_at_shape(const Obstacle& obstacle, const Look& look) {
    doubt_if(!look.all_have_length, Doubt::kZeroLength);
    if (obstacle.shape_type == ShapeType::kStairs) {
      look_at_stairs(obstacle, look);
    } else {
      look_at_chain(obstacle, look);
    }
    if (is_open_chain(obstacle.shape_type)) {
      survey_.open_chains_.push_back(static_cast<std::uint32_t>(i_));
      doubt_if(ends_may_come_near(obstacle.segments, options_.near_miss_m), Doubt::kEndNearItself);
    }
  }

  void look_at_stairs(const Obstacle& stairs, const Look& look) {
    doubt_if(!look.all_have_length || !chains_.all_apart(stairs.segments), Doubt::kChain);
    doubt_if(!look.all_have_length || !is_plain_flight(stairs.segments, options_), Doubt::kStairs);
  }

  void look_at_chain(const Obstacle& obstacle, const Look& look) {
    const bool is_ring = is_closed(obstacle.shape_type);
    ChainProof proof;
    if (look.all_have_length && look.is_joined) proof = chains_.chain(obstacle.segments, is_ring);
    const bool is_sound = proof.is_sound && !has_outer_;
    doubt_if(!is_sound, Doubt::kChain);
    doubt_if(!proof.has_no_spike, Doubt::kSpike);
    if (obstacle.shape_type != ShapeType::kRamp) return;
    doubt_if(!is_sound || !is_plain_ramp(obstacle, options_), Doubt::kRamp);
  }

  Survey& survey_;
  const std::vector<Obstacle>& obstacles_;
  const ValidationOptions& options_;
  ChainProver chains_;
  WordProver provers_;
  NameSet names_;
  std::size_t i_ = 0;       // the obstacle looked at
  bool has_outer_ = false;  // it calls itself an inner ring
};

Survey::Survey(const Map& map, const ValidationOptions& options, Proofs proofs) {
  Surveyor(*this, map, options).look();
  if (proofs == Proofs::kNone) doubt_everything(map);
}

void Survey::doubt_everything(const Map& map) {
  Positions all(map.obstacles.size());
  std::iota(all.begin(), all.end(), 0U);
  in_doubt_.fill(all);
  ids_may_repeat_ = names_may_repeat_ = true;
}

}  // namespace mapwright::validators
