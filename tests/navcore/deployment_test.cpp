#include "navcore/deployment/deployment.hpp"

#include <gtest/gtest.h>

#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright::navcore {
namespace {

using namespace mapwright::test;

// A yard with columns of different sizes, in which every place looks different.
Map yard() {
  return map({0, 20, 30, 0}, {hollow(1, 0, 0, 30, 20), box(2, 4, 4, 5, 7), box(3, 12, 9, 16, 10),
                              box(4, 22, 3, 23, 4), box(5, 25, 14, 28, 17), box(6, 8, 15, 9, 16)});
}

DeploymentSettings quick() {
  DeploymentSettings settings;
  settings.plans = 10;
  settings.localization_trials = 0;
  settings.localization.iterations = 6;
  settings.localization.filter.particles = 500;
  settings.localization.filter.first_particles = 3000;
  return settings;
}

TEST(Deployment, PlansAndReachesInAnOpenYard) {
  const auto outcome = run_deployment(yard(), quick());
  EXPECT_EQ(outcome.reachability.areas.size(), 1U);
  EXPECT_DOUBLE_EQ(outcome.reachability.largest_fraction, 1.0);
  EXPECT_DOUBLE_EQ(outcome.reachability.radius_m, 0.3);
  ASSERT_TRUE(outcome.planning.has_value());
  EXPECT_EQ(outcome.planning->trials, 10U);
  EXPECT_EQ(outcome.planning->solved, 10U);
  EXPECT_TRUE(outcome.planning->missed.empty());
  EXPECT_FALSE(outcome.localization.has_value());
}

TEST(Deployment, LocalizesTheSameForAnyNumberOfThreads) {
  DeploymentSettings settings = quick();
  settings.plans = 0;
  settings.localization_trials = 4;
  const auto one = run_deployment(yard(), settings);
  settings.threads = 3;
  const auto three = run_deployment(yard(), settings);
  ASSERT_TRUE(one.localization.has_value());
  EXPECT_FALSE(one.planning.has_value());
  EXPECT_EQ(one.localization->trials, 4U);
  EXPECT_EQ(one.localization->converged + one.localization->lost.size(), 4U);
  EXPECT_LE(one.localization->median_error_m, one.localization->p95_error_m);
  EXPECT_EQ(one.localization->converged, three.localization->converged);
  EXPECT_EQ(one.localization->median_error_m, three.localization->median_error_m);
  EXPECT_EQ(one.localization->p95_error_m, three.localization->p95_error_m);
}

TEST(Deployment, NothingRunsWhereTheRobotCannotStand) {
  DeploymentSettings settings = quick();
  settings.localization_trials = 2;
  const auto outcome = run_deployment(map10({box(1, -1, -1, 11, 11)}), settings);
  EXPECT_TRUE(outcome.reachability.areas.empty());
  EXPECT_FALSE(outcome.planning.has_value());
  EXPECT_FALSE(outcome.localization.has_value());
}

// A maze of walls with gaps hardly wider than the robot: a planner with few points misses the way.
TEST(PlanningTrials, NamesProvedPairsThatThePlannerMissed) {
  std::vector<Obstacle> walls;
  for (int i = 1; i < 10; ++i) {
    const double x = i;
    const double gap = i % 2 == 0 ? 1.0 : 8.4;
    walls.push_back(wall(2 * i, {{x, 0}, {x, gap}}));
    walls.push_back(wall(2 * i + 1, {{x, gap + 0.64}, {x, 10}}));
  }
  const FreeSpace space(map10(walls));
  const auto areas = TravelAreas::build(map10(walls), 0.3, RampPolicy::kFree);
  ASSERT_TRUE(areas.has_value());
  ASSERT_EQ(areas->areas().size(), 1U);
  PlanningTrialsSettings settings;
  settings.rrt.max_iterations = 20;
  const auto few = run_planning_trials(space, *areas, settings, 1);
  EXPECT_EQ(few.trials, 20U);
  EXPECT_FALSE(few.missed.empty());
  EXPECT_EQ(few.solved + few.missed.size(), few.trials);
  settings.rrt.max_iterations = 100000;
  const auto many = run_planning_trials(space, *areas, settings, 1);
  EXPECT_EQ(many.solved, many.trials);
}

}  // namespace
}  // namespace mapwright::navcore
