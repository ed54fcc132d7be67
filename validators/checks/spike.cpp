#include "validators/check.hpp"
#include "validators/shape/outline.hpp"
#include "validators/shape/spike_gap.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

void check_obstacle(const CheckContext& context, std::size_t i, FindingSink& sink) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const auto& segments = obstacle.segments;
  const double limit_m = context.options().spike_width_m;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Segment& before = segments[k == 0 ? segments.size() - 1 : k - 1];
    const Segment& segment = segments[k];
    if (before.b != segment.a) continue;
    const double gap = spike_gap_m(before.a - segment.a, segment.b - segment.a, limit_m);
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
  for (const auto i : context.in_doubt(Doubt::kSpike)) {
    if (obstacles[i].shape_type == ShapeType::kStairs) continue;
    const Outline& outline = context.outline(i);
    if (outline.is_ring && mean_width_m(outline) <= context.options().sliver_width_m) continue;
    check_obstacle(context, i, sink);
  }
}

}  // namespace mapwright::validators
