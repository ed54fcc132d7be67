#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// An end of an open chain, and what comes nearest to it.
struct End {
  std::uint32_t obstacle = 0;
  std::size_t segment = 0;
  bool is_start = false;
  Point at;
  bool is_joined = false;  // something touches it
  double gap_m = 0.0;
  std::uint32_t other = 0;
  std::size_t other_segment = 0;
};

// An open chain, and an obstacle that may come near to it.
struct Contact {
  std::uint32_t chain, other;
};

// By chain, then by the other.
std::vector<Contact> contacts_of(const CheckContext& context) {
  const auto& obstacles = context.map().obstacles;
  const auto is_chain = [&](std::uint32_t i) {
    return is_open_chain(obstacles[i].shape_type) && !obstacles[i].segments.empty();
  };
  std::vector<Contact> contacts;
  for (const auto i : context.in_doubt(Doubt::kEndNearItself)) {
    if (is_chain(i)) contacts.push_back({i, i});
  }
  for (const auto [first, second] : context.near_pairs()) {
    if (is_chain(first)) contacts.push_back({first, second});
    if (is_chain(second)) contacts.push_back({second, first});
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact& p, const Contact& q) {
    return std::tie(p.chain, p.other) < std::tie(q.chain, q.other);
  });
  return contacts;
}

class NearMisses {
 public:
  explicit NearMisses(const CheckContext& context)
      : context_(context),
        obstacles_(context.map().obstacles),
        reach_m_(context.options().near_miss_m),
        touch_m_(context.options().overlap_depth_m) {}

  // The ends that come near something without touching anything, in the order of the map.
  std::vector<End> found() {
    const auto contacts = contacts_of(context_);
    for (auto first = contacts.begin(); first != contacts.end();) {
      const auto last = std::find_if(first, contacts.end(), [&](const Contact& contact) {
        return contact.chain != first->chain;
      });
      const auto& segments = obstacles_[first->chain].segments;
      look_at({first, last}, {first->chain, 0, true, segments.front().a});
      look_at({first, last}, {first->chain, segments.size() - 1, false, segments.back().b});
      first = last;
    }
    return std::move(found_);
  }

 private:
  void look_at(std::span<const Contact> contacts, End end) {
    end.gap_m = 2.0 * reach_m_;
    for (const Contact& contact : contacts) {
      if (context_.box(contact.other).inflated(reach_m_).contains(end.at)) {
        look_at(contact.other, end);
      }
    }
    if (!end.is_joined && end.gap_m <= reach_m_) found_.push_back(end);
  }

  // Touching, or crossing (an end that reaches beyond), is joining.
  void look_at(std::uint32_t obstacle, End& end) const {
    const Segment& own = obstacles_[end.obstacle].segments[end.segment];
    context_.edges(obstacle).visit(box_around(end.at, reach_m_), [&](std::uint32_t k) {
      if (obstacle == end.obstacle && is_neighbour(k, end)) return;
      const Segment& s = obstacles_[obstacle].segments[k];
      const double gap_m = distance(end.at, closest_point_on_segment(end.at, s.a, s.b));
      const bool is_joined =
          gap_m <= touch_m_ || meet(own.a, own.b, s.a, s.b).kind != Meeting::kNone;
      end.is_joined = end.is_joined || is_joined;
      if (gap_m >= end.gap_m) return;
      end.gap_m = gap_m;
      end.other = obstacle;
      end.other_segment = k;
    });
  }

  static Box box_around(Point p, double by_m) { return Box{p.x, p.y, p.x, p.y}.inflated(by_m); }

  static bool is_neighbour(std::size_t k, const End& end) {
    return k == end.segment || (end.is_start ? k == end.segment + 1 : k + 1 == end.segment);
  }

  const CheckContext& context_;
  const std::vector<Obstacle>& obstacles_;
  double reach_m_, touch_m_;
  std::vector<End> found_;
};

void report(const CheckContext& context, const End& end, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  const Segment& near = obstacles[end.other].segments[end.other_segment];
  const Point foot = closest_point_on_segment(end.at, near.a, near.b);
  sink.segment(FindingCode::G120, end.obstacle, end.segment,
               end.is_start ? SegmentField::kAx : SegmentField::kBx, end.at,
               name_of(obstacles[end.obstacle], end.segment) +
                   (end.is_start ? " begins " : " ends ") + metres(end.gap_m) + " m from " +
                   name_of(obstacles[end.other], end.other_segment) + " at " + place_text(foot) +
                   "; move the end there, or farther away");
  sink.geometry() = {{end.at, foot}, {{end.at, foot}}, {}};
}

}  // namespace

void check_near_miss(const CheckContext& context, FindingSink& sink) {
  for (const End& end : NearMisses(context).found()) report(context, end, sink);
}

}  // namespace mapwright::validators
