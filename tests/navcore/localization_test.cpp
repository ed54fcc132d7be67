// The filter and the experiment as a whole, on a small square.
#include <gtest/gtest.h>

#include <cmath>

#include "navcore/localization/experiment.hpp"
#include "navcore/localization/roaming.hpp"
#include "navcore/localization/trial_summary.hpp"
#include "navcore/parallel.hpp"
#include "navcore/rays/culled_ray_caster.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

using test::box;
using test::wall;

// 30 m × 24 m without symmetry.
Map small_square() {
  Map map{{0, 24, 30, 0}, {}};
  map.obstacles = {box(1, {4, 3, 9, 6}, 3),
                   box(2, {14, 2, 15, 9}, 3),
                   box(3, {20, 14, 27, 20}, 3),
                   box(4, {6, 15, 8, 21}, 3),
                   box(5, {22, 4, 23, 5}, 3),
                   box(6, {12, 18, 13, 19}, 3),
                   wall(7, {0.5, 23.5}, {29.5, 23.5}, 2),
                   wall(8, {29.5, 23.5}, {29.5, 0.5}, 2),
                   wall(9, {29.5, 0.5}, {0.5, 0.5}, 2),
                   wall(10, {0.5, 0.5}, {0.5, 23.5}, 2)};
  return map;
}

class Localization : public testing::Test {
 protected:
  Map map_ = small_square();
  FreeSpace space_{map_};
  CulledRayCaster caster_{map_};
  RayCastingWeigher weigher_{caster_};

  // A quarter of the report's particles and half of its rays are plenty on a 30 m square.
  static ExperimentSettings small(FilterSettings filter) {
    ExperimentSettings settings;
    settings.laser.rays = 61;
    settings.filter = filter;
    settings.filter.particles = 1500;
    settings.filter.first_particles = std::min<std::size_t>(filter.first_particles, 6000);
    settings.iterations = 8;
    return settings;
  }
  Result<ExperimentRun> run(const ExperimentSettings& settings, const Pose& start,
                            std::uint64_t seed = 1) {
    return run_experiment(space_, caster_, weigher_, settings, start, seed);
  }
};

const Pose kStart{11.0, 12.0, Angle::from_degrees(30)};

TEST_F(Localization, FindsTheRobotFromAnywhere) {
  const auto runs = run_trials(space_, caster_, weigher_, small(robust_settings()), 20, 1, 2);
  ASSERT_TRUE(runs);
  std::size_t converged = 0;
  for (const auto& run : *runs) converged += run.converged();
  EXPECT_GE(converged, 18U);
}

TEST_F(Localization, FindsItWithoutACompass) {
  ExperimentSettings settings = small(robust_settings());
  settings.heading_known = false;
  settings.filter.first_particles = 20000;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->converged());
}

TEST_F(Localization, KeepsItsPlaceWithAFifthOfTheBeamsOccluded) {
  ExperimentSettings settings = small(robust_settings());
  settings.laser_noise.occlusion = 0.2;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->converged());
  EXPECT_LT(result->iterations.back().position_error_m, 0.15);
}

TEST_F(Localization, TracksFromAKnownPose) {
  ExperimentSettings settings = small(robust_settings());
  settings.filter.particles = 300;
  settings.initial_pose = Pose{kStart.x + 0.3, kStart.y - 0.3, kStart.theta};
  settings.iterations = 20;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->converged());
  for (const auto& iteration : result->iterations) EXPECT_LT(iteration.position_error_m, 0.5);
}

TEST_F(Localization, LooksSharply) {
  ExperimentSettings settings = small(robust_settings());
  settings.start_known = true;
  const auto sharp = run_trials(space_, caster_, weigher_, settings, 5, 1, 2);
  settings.filter.places.reset();
  settings.filter.settled_share = 2.0;
  const auto blunt = run_trials(space_, caster_, weigher_, settings, 5, 1, 2);
  ASSERT_TRUE(sharp && blunt);
  const auto median_m = [](const std::vector<ExperimentRun>& runs) {
    std::vector<double> errors_m;
    for (const auto& run : runs) {
      for (const auto& i : run.iterations) errors_m.push_back(i.position_error_m);
    }
    return quantile(errors_m, 0.5).value_or(0.0);
  };
  EXPECT_LT(median_m(*sharp), 0.02);
  EXPECT_LT(median_m(*sharp), 0.8 * median_m(*blunt));
}

TEST_F(Localization, SettledItGoesOnWithFewerParticles) {
  ExperimentSettings settings = small(robust_settings());
  settings.keep_particles = true;
  settings.filter.places->settled_particles = 400;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result && result->converged());
  EXPECT_GT(result->iterations[0].particles.size(), 1400U);
  EXPECT_LT(result->iterations.back().particles.size(), 1200U);
}

TEST_F(Localization, SearchesFromABeliefNearTheTruthWhenTheStartIsKnown) {
  ExperimentSettings settings = small(robust_settings());
  settings.start_known = true;
  settings.initial_sigma_m = 0.1;
  settings.iterations = 1;
  settings.filter.sweeps = 0;
  settings.keep_particles = true;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result);
  for (const Pose& pose : result->iterations[0].particles.poses) {
    EXPECT_LT(distance(pose.position(), kStart.position()), 1.0);
  }
}

TEST_F(Localization, SaysHowMuchWeightIsLeftAtTheTruth) {
  const auto found = run(small(robust_settings()), kStart);
  ASSERT_TRUE(found);
  EXPECT_GT(found->iterations.back().truth_share, 0.99);
  const ParticleSet set{{{0, 0, Angle()}, {0.5, 0, Angle()}, {3, 0, Angle()}}, {0.2, 0.3, 0.5}};
  EXPECT_DOUBLE_EQ(share_around(set, {0, 0, Angle()}), 0.5);
  EXPECT_DOUBLE_EQ(share_around(set, {9, 0, Angle()}), 0.0);
  EXPECT_DOUBLE_EQ(share_within(set, {0.3, 0, Angle()}, 0.25, 5.0), 0.3);
  EXPECT_DOUBLE_EQ(share_within(set, {0.3, 0, Angle::from_degrees(6)}, 0.25, 5.0), 0.0);
}

TEST_F(Localization, FindsAKidnappedRobotAgain) {
  const ExperimentSettings settings = small(robust_settings());
  ParticleFilter filter(weigher_, settings.laser, settings.filter, 1);
  ASSERT_TRUE(filter.start_anywhere(space_, HeadingPrior{kStart.theta, 3.0}));
  Random random(2);
  const auto look = [&](const Pose& pose) {
    filter.update(perceive(caster_, pose, settings.laser, {}, random));
    return distance(filter.estimate().pose.position(), pose.position());
  };
  for (int i = 0; i < 4; ++i) look(kStart);
  ASSERT_LT(look(kStart), 0.2);
  const Pose elsewhere{25.0, 8.0, kStart.theta};
  for (int i = 0; i < 10; ++i) look(elsewhere);
  EXPECT_LT(look(elsewhere), 0.2);
}

TEST_F(Localization, RunsTheReportsFilterLiterally) {
  ExperimentSettings settings = small(report_settings());
  settings.filter.particles = 2000;
  settings.filter.first_particles = 2000;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result);
  for (const auto& iteration : result->iterations) {
    EXPECT_EQ(iteration.update.particles, 2000U);
    EXPECT_TRUE(std::isfinite(iteration.update.effective_particles));
    EXPECT_FALSE(iteration.update.contradicted);
  }
}

TEST_F(Localization, TellsLikePlacesFromLostOnes) {
  ExperimentSettings settings = small(robust_settings());
  settings.filter.particles = 1;  // one particle is nowhere near
  settings.filter.first_particles = 1;
  settings.filter.elsewhere_particles = 0;
  const auto lost = run(settings, kStart);
  ASSERT_TRUE(lost);
  EXPECT_FALSE(lost->right_from());
  EXPECT_GT(lost->truth_advantage(), 100.0);
  EXPECT_TRUE(lost->lost());
  const auto found = run(small(robust_settings()), kStart);
  ASSERT_TRUE(found);
  EXPECT_LT(std::abs(found->truth_advantage()), 100.0);
  EXPECT_FALSE(found->truth_evidence);
}

TEST_F(Localization, IsTheSameForAnyNumberOfThreads) {
  ExperimentSettings settings = small(robust_settings());
  settings.iterations = 3;
  settings.keep_particles = true;
  const auto alone = run(settings, kStart, 5);
  settings.filter.threads = 3;
  const auto together = run(settings, kStart, 5);
  ASSERT_TRUE(alone && together);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(alone->iterations[i].particles.poses, together->iterations[i].particles.poses);
    EXPECT_EQ(alone->iterations[i].particles.weights, together->iterations[i].particles.weights);
  }
  const auto other_seed = run(settings, kStart, 6);
  EXPECT_NE(alone->iterations[0].particles.poses, other_seed->iterations[0].particles.poses);
}

TEST_F(Localization, TrialsAreTheSameForAnyNumberOfThreads) {
  ExperimentSettings settings = small(robust_settings());
  settings.iterations = 2;
  const auto one = run_trials(space_, caster_, weigher_, settings, 4, 9, 1);
  const auto three = run_trials(space_, caster_, weigher_, settings, 4, 9, 3);
  ASSERT_TRUE(one && three);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ((*one)[i].start, (*three)[i].start);
    EXPECT_EQ((*one)[i].iterations[1].estimate.pose, (*three)[i].iterations[1].estimate.pose);
  }
}

TEST_F(Localization, KeepsParticlesOutOfSolids) {
  ExperimentSettings settings = small(robust_settings());
  settings.iterations = 1;
  settings.keep_particles = true;
  const auto result = run(settings, kStart);
  ASSERT_TRUE(result);
  for (const Pose& pose : result->iterations[0].particles.poses) {
    EXPECT_TRUE(space_.is_free(pose.position()));
  }
}

TEST_F(Localization, RefusesAStartInsideOfASolid) {
  const auto inside = run(small(robust_settings()), {5, 4, Angle()});
  ASSERT_FALSE(inside);
  EXPECT_EQ(inside.error().kind, FailureKind::kUsage);
  EXPECT_FALSE(run(small(robust_settings()), {-5, 4, Angle()}));
}

TEST_F(Localization, RefusesAMapWithoutFreeSpace) {
  const Map solid{{0, 10, 10, 0}, {box(1, {-1, -1, 11, 11}, 3)}};
  const FreeSpace nowhere(solid);
  EXPECT_FALSE(run_trials(nowhere, caster_, weigher_, small(robust_settings()), 1, 1, 1));
}

TEST_F(Localization, DrivesWithoutTouchingAnything) {
  Random random(3);
  Pose pose = kStart;
  double driven_m = 0.0;
  for (int i = 0; i < 500; ++i) {
    const OdometryStep step = stroll(space_, pose, 1.0, 0.4, random);
    const Pose next = moved(pose, step);
    ASSERT_TRUE(space_.is_free(next.position(), 0.4));
    ASSERT_TRUE(space_.is_free_way(pose.position(), next.position(), 0.4));
    driven_m += step.distance_m;
    pose = next;
  }
  EXPECT_GT(driven_m, 450.0);
}

TEST(Roaming, PrefersRoomToPockets) {
  // A cell of 4 m × 4 m behind walls, and a yard of 40 m × 40 m.
  const Map map{{0, 40, 50, 0},
                {box(1, {43, 3, 43.2, 8}, 2), box(2, {48, 3, 48.2, 8}, 2),
                 box(3, {43, 8, 48.2, 8.2}, 2), box(4, {43, 2.8, 48.2, 3}, 2)}};
  const FreeSpace space(map);
  EXPECT_LT(roaming_area_m2(space, {45.5, 5.5}, 0.4, 200), 20.0);
  EXPECT_EQ(roaming_area_m2(space, {20, 20}, 0.4, 200), 200.0);
  EXPECT_EQ(roaming_area_m2(space, {43.1, 5}, 0.4, 200), 0.0);
  Random random(1);
  const Box pocket{43, 3, 48, 8};
  for (int i = 0; i < 200; ++i) {
    const auto place = sample_roaming_place(space, 0.4, random);
    ASSERT_TRUE(place);
    EXPECT_FALSE(pocket.contains(*place));
  }
}

TEST(ParallelFor, VisitsEachIndexOnce) {
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    std::vector<int> visits(1001, 0);
    parallel_for(visits.size(), 10, threads, [&](std::size_t begin, std::size_t end) {
      EXPECT_LE(end - begin, 10U);
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(1001, 1));
  }
  parallel_for(0, 10, 2, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsAFailure) {
  EXPECT_THROW(parallel_for(100, 1, 3,
                            [](std::size_t begin, std::size_t) {
                              if (begin == 50) throw std::runtime_error("50");
                            }),
               std::runtime_error);
}

}  // namespace
}  // namespace mapwright::navcore
