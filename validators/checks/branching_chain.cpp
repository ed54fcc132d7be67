#include "validators/check.hpp"
#include "validators/shape/branches.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_branching_chain(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    const Obstacle& obstacle = obstacles[i];
    if (obstacle.shape_type == ShapeType::kStairs || context.outline(i).is_joined ||
        !context.is_complete(i)) {
      continue;
    }
    const auto branches = branches_of(obstacle);
    for (std::size_t k = 0; k < branches.size(); ++k) {
      if (!branches[k]) continue;
      sink.segment(FindingCode::G123, i, k,
                   name_of(obstacle, k) + " branches off at " + place_text(obstacle.segments[k].a) +
                       ", where the chain has passed already; begin an obstacle of its own there");
      sink.geometry().points.push_back(obstacle.segments[k].a);
    }
  }
}

}  // namespace mapwright::validators
