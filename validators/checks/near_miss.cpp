#include <algorithm>
#include <cstdint>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
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

std::vector<End> ends_of_chains(const CheckContext& context) {
  std::vector<End> ends;
  const auto& obstacles = context.map().obstacles;
  for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
    const auto& segments = obstacles[i].segments;
    if (!is_open_chain(obstacles[i].shape_type) || segments.empty()) continue;
    ends.push_back({i, 0, true, segments.front().a});
    ends.push_back({i, segments.size() - 1, false, segments.back().b});
  }
  return ends;
}

SegmentIndex index_over(const std::vector<End>& ends) {
  std::vector<IndexedSegment> points;
  points.reserve(ends.size());
  for (std::uint32_t i = 0; i < ends.size(); ++i) points.push_back({ends[i].at, ends[i].at, i});
  return SegmentIndex(std::move(points));
}

Box box_around(Point p, double by_m) {
  return Box{p.x, p.y, p.x, p.y}.inflated(by_m);
}

class NearMisses {
 public:
  explicit NearMisses(const CheckContext& context)
      : context_(context),
        obstacles_(context.map().obstacles),
        reach_m_(context.options().near_miss_m),
        touch_m_(context.options().overlap_depth_m),
        ends_(ends_of_chains(context)) {}

  // The ends that come near something without touching anything, in the order of the map.
  std::vector<End> found() {
    if (ends_.empty()) return {};
    for (auto& end : ends_) end.gap_m = 2.0 * reach_m_;
    const SegmentIndex index = index_over(ends_);
    for (std::uint32_t i = 0; i < obstacles_.size(); ++i) {
      index.query(context_.outlines()[i].box.inflated(reach_m_), [&](std::size_t k) {
        look_at(i, ends_[index[k].tag]);
        return true;
      });
    }
    std::erase_if(ends_, [&](const End& end) { return end.is_joined || !(end.gap_m <= reach_m_); });
    return std::move(ends_);
  }

 private:
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

  static bool is_neighbour(std::size_t k, const End& end) {
    return k == end.segment || (end.is_start ? k == end.segment + 1 : k + 1 == end.segment);
  }

  const CheckContext& context_;
  const std::vector<Obstacle>& obstacles_;
  double reach_m_, touch_m_;
  std::vector<End> ends_;
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
