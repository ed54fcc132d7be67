#include "navcore/deployment/planning_trials.hpp"

#include <optional>

namespace mapwright::navcore {
namespace {

constexpr int kMostDraws = 1000;

std::optional<Point> sample_largest_area(const FreeSpace& space, const TravelAreas& areas,
                                         double radius_m, Random& random) {
  for (int i = 0; i < kMostDraws; ++i) {
    const auto p = space.sample(random, radius_m);
    if (!p) return std::nullopt;
    if (areas.area_at(*p) == std::size_t{0}) return p;
  }
  return std::nullopt;
}

}  // namespace

PlanningTrials run_planning_trials(const FreeSpace& space, const TravelAreas& areas,
                                   const PlanningTrialsSettings& settings, std::uint64_t seed) {
  PlanningTrials result;
  if (areas.areas().empty()) return result;
  for (std::size_t i = 0; i < settings.trials; ++i) {
    Random random(seed, i);
    const auto start = sample_largest_area(space, areas, settings.radius_m, random);
    const auto goal = sample_largest_area(space, areas, settings.radius_m, random);
    if (!start || !goal) continue;
    ++result.trials;
    const auto plan =
        plan_balanced_rrt(space, {*start, *goal, settings.radius_m}, settings.rrt, random);
    if (plan.solved) {
      ++result.solved;
    } else {
      result.missed.push_back({*start, *goal, plan.iterations});
    }
  }
  return result;
}

}  // namespace mapwright::navcore
