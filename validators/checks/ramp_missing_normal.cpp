#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_ramp_missing_normal(const CheckContext& context, FindingSink& sink) {
  for_each_ramp(context, [&](const Obstacle& ramp, std::size_t i) {
    if (ramp.semantic.value(semantic_key::kNormal)) return;
    sink.obstacle(FindingCode::T201, i, ObstacleField::kSemantic,
                  name_of(ramp) +
                      " is a ramp but does not say how it slopes; add "
                      "normal=nx:ny:nz, the unit normal of its surface");
  });
}

}  // namespace mapwright::validators
