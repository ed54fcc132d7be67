#include "navcore/localization/place_prior.hpp"

#include <cmath>

namespace mapwright::navcore {
namespace {

double density_in(const FlatPrior& prior, const Pose& pose) {
  if (place_cell(pose) != prior.cell || !prior.space->is_free(pose.position())) return -HUGE_VAL;
  return prior.log_density_m2 + log_density(prior.heading, pose.theta);
}

double density_in(const TrackedPrior& prior, const Pose& pose) {
  return prior.log_share + prior.belief.log_density(pose) + prior.belief.log_normaliser();
}

}  // namespace

double log_density(const PlacePrior& prior, const Pose& pose) {
  return std::visit([&](const auto& known) { return density_in(known, pose); }, prior);
}

}  // namespace mapwright::navcore
