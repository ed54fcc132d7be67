#include <algorithm>
#include <cmath>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

bool lies_within(const Box& box, const Border& border) {
  return border.contains({box.min_x, box.min_y}) && border.contains({box.max_x, box.max_y});
}

double distance_to(const Border& border, Point p) {
  const Point nearest{std::clamp(p.x, border.left, border.right),
                      std::clamp(p.y, border.bottom, border.top)};
  return distance(p, nearest);
}

bool is_absurd(Point p, double limit_m) {
  return std::abs(p.x) > limit_m || std::abs(p.y) > limit_m;
}

// Reports the first point beyond the border; one finding an obstacle. Absurd coordinates are told
// of already (G102).
void report_first_beyond(const CheckContext& context, std::size_t i, FindingSink& sink) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const Border& border = context.map().border;
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const Segment& segment = obstacle.segments[k];
    const bool at_start = !border.contains(segment.a);
    const Point p = at_start ? segment.a : segment.b;
    if (border.contains(p) || is_absurd(p, context.options().max_coordinate_m)) continue;
    sink.segment(FindingCode::G109, i, k, at_start ? SegmentField::kAx : SegmentField::kBx, p,
                 name_of(obstacle, k) + " reaches " + metres(distance_to(border, p)) +
                     " m beyond the border, to " + place_text(p) +
                     "; move it, or widen the border");
    return;
  }
}

}  // namespace

void check_outside_border(const CheckContext& context, FindingSink& sink) {
  if (!context.has_usable_border()) return;
  const Box& all = context.survey().extent();
  if (all.is_empty() || lies_within(all, context.map().border)) return;
  for (std::size_t i = 0; i < context.map().obstacles.size(); ++i) {
    const Box& box = context.box(i);
    if (box.is_empty() || lies_within(box, context.map().border)) continue;
    report_first_beyond(context, i, sink);
  }
}

}  // namespace mapwright::validators
