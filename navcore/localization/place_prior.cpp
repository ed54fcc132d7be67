#include "navcore/localization/place_prior.hpp"

#include <cmath>

namespace mapwright::navcore {
namespace {

double density_in(const FlatPrior& prior, const Pose& pose) {
  if (place_cell(pose) != prior.cell || !prior.space->is_free(pose.position())) return -HUGE_VAL;
  return prior.log_density_m2 + log_density(prior.heading, pose.theta);
}

double density_in(const TrackedPrior& prior, const Pose& pose) {
  return prior.log_share + prior.poses.log_density(pose);
}

}  // namespace

bool is_way(const FreeSpace& space, Point from, Point to, double radius_m) {
  return space.is_free(to, radius_m) && space.is_free_way(from, to, radius_m);
}

double log_density(const PlacePrior& prior, const Pose& pose) {
  return std::visit([&](const auto& known) { return density_in(known, pose); }, prior);
}

double log_way(const PlacePrior& prior, const Pose& pose) {
  const auto* tracked = std::get_if<TrackedPrior>(&prior);
  if (tracked == nullptr || tracked->space == nullptr) return 0.0;
  const Point from = tracked->poses.origin_of(pose).position();
  const bool free = is_way(*tracked->space, from, pose.position(), tracked->robot_radius_m);
  return free ? 0.0 : tracked->log_through_barrier;
}

}  // namespace mapwright::navcore
