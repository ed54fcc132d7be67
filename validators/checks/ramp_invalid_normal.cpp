#include <cmath>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

double length(const Normal& n) {
  return std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
}

// Empty where the normal is a unit vector that points up.
std::string defect_of(const Obstacle& ramp, double tolerance) {
  const auto normal = ramp_normal(ramp);
  if (!normal) return "is not three numbers like 0:-0.0995:0.995";
  if (!(normal->z > 0.0)) return "does not point up; its third number must be above 0";
  const double length = validators::length(*normal);
  if (std::abs(length - 1.0) <= tolerance) return "";
  return "has the length " + metres(length) + "; divide its numbers by that";
}

}  // namespace

void check_ramp_invalid_normal(const CheckContext& context, FindingSink& sink) {
  for_each_ramp(context, [&](const Obstacle& ramp, std::size_t i) {
    const auto text = ramp.semantic.value(semantic_key::kNormal);
    if (!text) return;
    const std::string defect = defect_of(ramp, context.options().unit_normal_error);
    if (defect.empty()) return;
    sink.obstacle(FindingCode::T202, i, ObstacleField::kSemantic,
                  "the normal '" + std::string(*text) + "' of " + name_of(ramp) + " " + defect);
  });
}

}  // namespace mapwright::validators
