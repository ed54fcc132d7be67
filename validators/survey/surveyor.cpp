#include "validators/survey/surveyor.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "validators/survey/flight_proof.hpp"
#include "validators/survey/ramp_proof.hpp"

namespace mapwright::validators {

struct SegmentLook {
  Box box = kEmptyBox;
  double least_height_m = HUGE_VAL, greatest_height_m = -HUGE_VAL;
  bool all_have_length = true;
  bool is_joined = true;
  bool has_one_side = true;  // indoor or outdoor
};

namespace {

SegmentLook look_of(std::span<const Segment> segments) {
  SegmentLook look;
  Point end = segments.front().a;
  const InOut side = segments.front().in_out;
  look.box.add(end);
  for (const Segment& segment : segments) {
    if (segment.a != end) {
      look.box.add(segment.a);
      look.is_joined = false;
    }
    look.box.add(segment.b);
    look.least_height_m = std::min(look.least_height_m, segment.height_m);
    look.greatest_height_m = std::max(look.greatest_height_m, segment.height_m);
    look.all_have_length &= segment.a != segment.b;
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

// Of an obstacle whose segments are about to go.
Obstacle copy_of(const ObstacleView& obstacle) {
  return {obstacle.id, obstacle.shape_type, std::string(obstacle.semantic),
          std::vector<Segment>(obstacle.segments.begin(), obstacle.segments.end())};
}

}  // namespace

void Surveyor::doubt(Doubt doubt) {
  has_doubts_ = true;
  survey_.in_doubt_[static_cast<std::size_t>(doubt)].push_back(
      static_cast<std::uint32_t>(survey_.boxes_.size()));
}

void Surveyor::look_at(const ObstacleView& obstacle) {
  look_at_id(obstacle.id);
  look_at_words(obstacle);
  if (obstacle.segments.empty()) {
    for (const Doubt each : {Doubt::kEmpty, Doubt::kChain, Doubt::kLow}) doubt(each);
    survey_.boxes_.push_back(kEmptyBox);
  } else {
    look_at_segments(obstacle);
  }
  last_id_ = obstacle.id;
  last_semantic_ = obstacle.semantic;
}

void Surveyor::look_at_id(std::int64_t id) {
  doubt_if(id < 0, Doubt::kNegativeId);
  if (!survey_.boxes_.empty() && id <= last_id_) survey_.ids_may_repeat_ = true;
}

void Surveyor::look_at_words(const ObstacleView& obstacle) {
  const Words words = words_.words_of(obstacle.semantic);
  bool are_sound = words.are_sound;
  const char* last = nullptr;
  for (const Segment& segment : obstacle.segments) {
    const char* const text = segment.semantic.view().data();
    if (text != last) are_sound = are_sound && words_.are_sound(segment.semantic);
    last = text;
  }
  doubt_if(!are_sound, Doubt::kWords);
  doubt_if(words.have_outer, Doubt::kInnerRing);
  has_outer_ = words.have_outer;
  saw_a_source_ = saw_a_source_ || words.have_source;
  // The parts of one feature follow each other.
  const bool is_part = !survey_.boxes_.empty() && obstacle.semantic == last_semantic_;
  if (words.have_name && !is_part) look_at_name(words);
}

void Surveyor::look_at_name(const Words& words) {
  if (!words.are_sound) survey_.names_may_repeat_ = true;
  if (!words.have_outer) names_.add(words.name, words.level);
}

void Surveyor::look_at_segments(const ObstacleView& obstacle) {
  const SegmentLook look = look_of(obstacle.segments);
  doubt_if(!(farthest(look.box) <= options_.max_coordinate_m), Doubt::kCoordinates);
  look_at_attributes(obstacle, look);
  look_at_shape(obstacle, look);
  add_box(look.box);
}

void Surveyor::add_box(const Box& box) {
  survey_.boxes_.push_back(box);
  survey_.extent_.add({box.min_x, box.min_y});
  survey_.extent_.add({box.max_x, box.max_y});
}

void Surveyor::look_at_attributes(const ObstacleView& obstacle, const SegmentLook& look) {
  const double greatest_m = look.greatest_height_m;
  doubt_if(!(look.least_height_m >= 0.0 && greatest_m <= options_.max_height_m), Doubt::kHeights);
  doubt_if(!look.has_one_side, Doubt::kMixedInOut);
  if (!stands_by_itself(obstacle.shape_type)) return;
  doubt_if(!(greatest_m > std::max(options_.laser_height_m, 0.0)), Doubt::kLow);
  doubt_if(!(greatest_m <= options_.suspect_height_m), Doubt::kHigh);
}

void Surveyor::look_at_shape(const ObstacleView& obstacle, const SegmentLook& look) {
  doubt_if(!look.all_have_length, Doubt::kZeroLength);
  if (obstacle.shape_type == ShapeType::kStairs) {
    look_at_stairs(obstacle, look);
  } else {
    look_at_chain(obstacle, look);
  }
  if (is_open_chain(obstacle.shape_type)) {
    survey_.open_chains_.push_back(static_cast<std::uint32_t>(survey_.boxes_.size()));
    doubt_if(ends_may_come_near(obstacle.segments, options_.near_miss_m), Doubt::kEndNearItself);
  }
}

void Surveyor::look_at_stairs(const ObstacleView& stairs, const SegmentLook& look) {
  doubt_if(!look.all_have_length || !chains_.all_apart(stairs.segments), Doubt::kChain);
  doubt_if(!look.all_have_length || !is_plain_flight(stairs.segments, options_), Doubt::kStairs);
}

void Surveyor::look_at_chain(const ObstacleView& obstacle, const SegmentLook& look) {
  const bool is_ring = is_closed(obstacle.shape_type);
  ChainProof proof;
  if (look.all_have_length && look.is_joined) proof = chains_.chain(obstacle.segments, is_ring);
  const bool is_sound = proof.is_sound && !has_outer_;
  doubt_if(!is_sound, Doubt::kChain);
  doubt_if(!proof.has_no_spike, Doubt::kSpike);
  if (obstacle.shape_type != ShapeType::kRamp) return;
  doubt_if(!is_sound || !is_plain_ramp(copy_of(obstacle), options_), Doubt::kRamp);
}

Survey Surveyor::survey() && {
  if (names_.may_repeat()) survey_.names_may_repeat_ = true;
  return std::move(survey_);
}

}  // namespace mapwright::validators
