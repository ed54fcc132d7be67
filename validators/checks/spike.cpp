#include <algorithm>
#include <cmath>

#include "validators/check.hpp"
#include "validators/shape/outline.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Tangent of the sharpest corner that is no spike whatever its arms: about 10°.
constexpr double kSharp = 0.18;

// Distance between the arms of a corner where the shorter one ends; infinite where they open wide
// or the corner is smaller than the limit itself. Arms that lie on each other are told of by G104.
double gap_m(Point u, Point v, double limit_m) {
  const double along = dot(u, v), across = std::abs(cross(u, v));
  if (along <= 0.0 || across == 0.0 || across > kSharp * along) return HUGE_VAL;
  const double shorter_m = std::min(length(u), length(v)),
               longer_m = std::max(length(u), length(v));
  return shorter_m <= limit_m ? HUGE_VAL : across / longer_m;
}

void check_obstacle(const CheckContext& context, std::size_t i, FindingSink& sink) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const auto& segments = obstacle.segments;
  const double limit_m = context.options().spike_width_m;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Segment& before = segments[k == 0 ? segments.size() - 1 : k - 1];
    const Segment& segment = segments[k];
    if (before.b != segment.a) continue;
    const double gap = gap_m(before.a - segment.a, segment.b - segment.a, limit_m);
    if (gap > limit_m) continue;
    sink.segment(FindingCode::G121, i, k,
                 name_of(obstacle, k) + " runs back along the one before it, at most " +
                     metres(gap) + " m beside it; take the vertex " + place_text(segment.a) +
                     " away");
    sink.geometry() = {{segment.a}, {{before.a, segment.a, segment.b}}, {}};
  }
}

}  // namespace

// Slivers have two spikes; G122 tells of them.
void check_spike(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (obstacles[i].shape_type == ShapeType::kStairs) continue;
    const Outline& outline = context.outlines()[i];
    if (outline.is_ring && mean_width_m(outline) <= context.options().sliver_width_m) continue;
    check_obstacle(context, i, sink);
  }
}

}  // namespace mapwright::validators
