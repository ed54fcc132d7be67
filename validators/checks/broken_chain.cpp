#include "validators/check.hpp"
#include "validators/shape/branches.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// A segment written twice breaks the chain too, G111 tells of it; of branches G123.
void check_obstacle(const Obstacle& obstacle, std::size_t i, FindingSink& sink) {
  const auto branches = branches_of(obstacle);
  for (std::size_t k = 1; k < obstacle.segments.size(); ++k) {
    const Segment& before = obstacle.segments[k - 1];
    const Segment& segment = obstacle.segments[k];
    if (before.b == segment.a || branches[k] || repeats_the_one_before(obstacle, k)) continue;
    sink.segment(FindingCode::G106, i, k,
                 name_of(obstacle, k) + " begins at " + place_text(segment.a) + ", " +
                     metres(distance(before.b, segment.a)) +
                     " m from where the one before it ends, " + place_text(before.b) +
                     "; join them, or make two obstacles of it");
    sink.geometry() = {{before.b, segment.a}, {{before.a, before.b}, {segment.a, segment.b}}, {}};
  }
}

}  // namespace

void check_broken_chain(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    if (obstacles[i].shape_type == ShapeType::kStairs) continue;
    const bool is_broken = !context.outline(i).is_joined && context.is_complete(i);
    if (is_broken) check_obstacle(obstacles[i], i, sink);
  }
}

}  // namespace mapwright::validators
