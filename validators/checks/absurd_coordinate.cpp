#include <algorithm>
#include <array>
#include <cmath>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

constexpr std::string_view kAdvice =
    "; is this a map in UTM or geographic coordinates? Subtract the origin, or convert it again";

bool is_absurd(Point p, double limit_m) {
  return std::abs(p.x) > limit_m || std::abs(p.y) > limit_m;
}

void check_border(const CheckContext& context, FindingSink& sink) {
  const Border& border = context.map().border;
  const double limit_m = context.options().max_coordinate_m;
  if (!is_absurd({border.left, border.top}, limit_m) &&
      !is_absurd({border.right, border.bottom}, limit_m)) {
    return;
  }
  sink.border(FindingCode::G102, "the border reaches farther than " + metres(limit_m) +
                                     " m from the origin" + std::string(kAdvice));
}

struct Coordinate {
  double value;
  SegmentField field;
};

// A map in the wrong frame has this defect at each of its points: once for an obstacle is enough.
void check_obstacle(const CheckContext& context, std::size_t i, FindingSink& sink) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const double limit_m = context.options().max_coordinate_m;
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const Segment& s = obstacle.segments[k];
    if (!is_absurd(s.a, limit_m) && !is_absurd(s.b, limit_m)) continue;
    const std::array<Coordinate, 4> coordinates{{{s.a.x, SegmentField::kAx},
                                                 {s.a.y, SegmentField::kAy},
                                                 {s.b.x, SegmentField::kBx},
                                                 {s.b.y, SegmentField::kBy}}};
    const auto worst = *std::find_if(
        coordinates.begin(), coordinates.end(),
        [&](const Coordinate& coordinate) { return std::abs(coordinate.value) > limit_m; });
    const bool at_start = worst.field == SegmentField::kAx || worst.field == SegmentField::kAy;
    sink.segment(FindingCode::G102, i, k, worst.field, at_start ? s.a : s.b,
                 name_of(obstacle, k) + " has the coordinate " + metres(worst.value) +
                     " m, farther than " + metres(limit_m) + " m from the origin" +
                     std::string(kAdvice));
    return;
  }
}

}  // namespace

void check_absurd_coordinate(const CheckContext& context, FindingSink& sink) {
  check_border(context, sink);
  for (const auto i : context.in_doubt(Doubt::kCoordinates)) check_obstacle(context, i, sink);
}

}  // namespace mapwright::validators
