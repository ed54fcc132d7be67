#include <algorithm>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_missing_height(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kLow)) {
    const Obstacle& obstacle = obstacles[i];
    if (obstacle.shape_type == ShapeType::kStairs || obstacle.shape_type == ShapeType::kRamp) {
      continue;
    }
    const auto& segments = obstacle.segments;
    const bool is_flat =
        !segments.empty() && std::all_of(segments.begin(), segments.end(),
                                         [](const Segment& s) { return s.height_m == 0.0; });
    if (!is_flat) continue;
    sink.segment(FindingCode::S122, i, 0, SegmentField::kHeight, segments.front().a,
                 name_of(obstacle) +
                     " has height 0 throughout, as if it were not there; give it its height, or "
                     "remove it");
  }
}

}  // namespace mapwright::validators
