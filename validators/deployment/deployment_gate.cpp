#include "validators/deployment/deployment_gate.hpp"

#include <cmath>
#include <iterator>
#include <utility>

namespace mapwright::validators {
namespace {

bool has_usable_border(const Border& border) {
  return border.right > border.left && border.top > border.bottom &&
         std::isfinite(border.right - border.left) && std::isfinite(border.top - border.bottom);
}

}  // namespace

GateOutcome check_deployment(const MapDocument& document, const GateOptions& options) {
  GateOutcome outcome;
  // The laser that localizes is the one that overlooks things (S121).
  ValidationOptions limits = options.validation;
  limits.laser_height_m = options.deployment.localization.laser.height_m;
  outcome.findings = validate(document, limits);
  for (const auto& obstacle : document.map.obstacles) outcome.obstacle_ids.push_back(obstacle.id);
  if (!has_usable_border(document.map.border)) return outcome;
  outcome.deployment = navcore::run_deployment(document.map, options.deployment);
  auto more = deployment_findings(document, *outcome.deployment, options);
  outcome.findings.insert(outcome.findings.end(), std::make_move_iterator(more.begin()),
                          std::make_move_iterator(more.end()));
  return outcome;
}

}  // namespace mapwright::validators
