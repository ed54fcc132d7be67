// Places weighed against each other.
#include "navcore/localization/place_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "navcore/engine/scan_engine.hpp"
#include "navcore/localization/experiment.hpp"
#include "navcore/localization/truth_evidence.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

using test::box;
using test::wall;

constexpr double kNextRoom_m = 20.0;

Pose pose_at(double x, double y, double deg) {
  return {x, y, Angle::from_degrees(deg)};
}

void add_room(Map& map, double left) {
  const std::int64_t id = static_cast<std::int64_t>(map.obstacles.size()) + 1;
  map.obstacles.push_back(wall(id, {left, 2}, {left + 11, 2}, 2));
  map.obstacles.push_back(wall(id + 1, {left + 11, 2}, {left + 11, 9}, 2));
  map.obstacles.push_back(wall(id + 2, {left + 11, 9}, {left, 9}, 2));
  map.obstacles.push_back(wall(id + 3, {left, 9}, {left, 2}, 2));
  map.obstacles.push_back(box(id + 4, {left + 7, 6, left + 8, 7}, 2));
}

// Two rooms that are the same, but for a pillar in the second one.
Map two_rooms(bool pillar) {
  Map map{{0, 12, 40, 0}, {}};
  add_room(map, 2.0);
  add_room(map, 2.0 + kNextRoom_m);
  if (pillar) map.obstacles.push_back(box(99, {24.0, 7.0, 24.2, 7.2}, 2));
  return map;
}

class Places : public testing::Test {
 protected:
  explicit Places(bool pillar = false) : map_(two_rooms(pillar)) {}

  std::vector<double> scan_at(const Pose& pose) {
    Random random(7);
    return perceive(engine_, pose, laser_, {}, random);
  }
  ScanEvidence evidence(const std::vector<double>& scan) const {
    return {scan, laser_, robust_settings().likelihood, &engine_, 1};
  }
  // With this probability a step of a metre has led the robot to around the pose.
  static Place around(const Pose& pose, double share, std::size_t count,
                      const OdometryNoise& noise = kNoise) {
    const ParticleSet from = with_equal_weights({moved(pose, {Angle(), -1.0, Angle()})});
    return {TrackedPrior{MovedPoses(from, kStep, noise), std::log(share), nullptr, 0.0, 0.0},
            PoseBelief(with_equal_weights({pose}), 0.1, 2.0), count, 0};
  }
  static double first_share(const PlaceSample& sample, std::size_t count) {
    return std::accumulate(sample.particles.weights.begin(),
                           sample.particles.weights.begin() + static_cast<std::ptrdiff_t>(count),
                           0.0);
  }

  static inline const OdometryStep kStep{Angle(), 1.0, Angle()};
  static constexpr OdometryNoise kNoise{0.0, 0.03, 0.1, 0.0};

  Map map_;
  FreeSpace space_{map_};
  ScanEngine engine_{map_};
  LaserModel laser_{61, 180.0, 15.0, 0.5};
  const std::vector<PlaceStage> stages_ = robust_settings().places->stages;
};

class UnequalPlaces : public Places {
 protected:
  UnequalPlaces() : Places(true) {}
};

TEST_F(Places, ThatAreAlikeKeepTheirSharesWhateverTheirParticles) {
  const Pose truth = pose_at(5.0, 5.0, 20.0), other = pose_at(5.0 + kNextRoom_m, 5.0, 20.0);
  const auto scan = scan_at(truth);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto sample = sample_places({around(truth, 0.25, 60), around(other, 0.75, 600)}, stages_,
                                      evidence(scan), seed, 0);
    EXPECT_NEAR(first_share(sample, 60), 0.25, 0.12) << seed;
  }
}

// A metre and a turn of 20° against a centimetre and a tenth of a degree: one draw meets nothing.
TEST_F(Places, AreDrawnFromAgainUntilTheyAreMet) {
  const Pose truth = pose_at(5.0, 5.0, 20.0);
  const auto scan = scan_at(truth);
  const auto vaguely = [](const Pose& pose, std::size_t count) {
    Place place = around(pose, 0.5, count, {0.0, 0.1, 0.3, 0.0});
    place.proposal = PoseBelief(with_equal_weights({pose}), 0.3, 7.0);
    return place;
  };
  const std::vector<PlaceStage> at_once{{0.06, 0.6}};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto sample =
        sample_places({vaguely(truth, 120), vaguely(pose_at(25.0, 5.0, 20.0), 1200)}, at_once,
                      evidence(scan), seed, 0);
    EXPECT_NEAR(first_share(sample, 120), 0.5, 0.2) << seed;
  }
}

TEST_F(UnequalPlaces, AreToldApart) {
  const Pose truth = pose_at(5.0, 5.0, 60.0), other = pose_at(5.0 + kNextRoom_m, 5.0, 60.0);
  const auto scan = scan_at(truth);
  const auto sample = sample_places({around(truth, 0.1, 60), around(other, 0.9, 600)}, stages_,
                                    evidence(scan), 1, 0);
  EXPECT_GT(first_share(sample, 60), 0.9);
}

// By hand: the mean likelihood of poses drawn from the prior.
TEST_F(UnequalPlaces, WeighWhatTheMeanLikelihoodOverThePriorIs) {
  const Pose truth = pose_at(5.0, 5.0, 60.0), other = pose_at(5.3, 5.2, 66.0);
  const auto scan = scan_at(truth);
  const std::vector<PlaceStage> blunt{{0.3, 0.1}};
  LikelihoodModel likelihood = robust_settings().likelihood;
  likelihood.sigma_m = 0.3;
  const auto mean_likelihood = [&](const Pose& middle) {
    const Pose from = moved(middle, {Angle(), -1.0, Angle()});
    Random random(3);
    std::vector<Pose> poses;
    for (int i = 0; i < 20000; ++i) poses.push_back(moved(from, perturbed(kStep, kNoise, random)));
    std::vector<double> factors(poses.size());
    engine_.weigh(scan, laser_, likelihood, poses, factors, 1);
    double sum = 0.0;
    for (const double factor : factors) sum += std::exp(0.1 * factor);
    return sum;
  };
  const double a = mean_likelihood(truth), b = mean_likelihood(other);
  const std::vector<PlaceStage> in_stages{{0.6, 0.02}, {0.3, 0.1}, {0.3, 0.1}};
  for (const auto& stages : {blunt, in_stages}) {
    const auto sample = sample_places({around(truth, 0.5, 2000), around(other, 0.5, 2000)}, stages,
                                      evidence(scan), 1, 0);
    EXPECT_NEAR(first_share(sample, 2000), a / (a + b), 0.02) << stages.size();
  }
}

TEST_F(Places, AFlatPriorEndsWithItsCellAndWhereFreeSpaceDoes) {
  const Pose inside = pose_at(9.5, 5.5, 30.0);
  const FlatPrior prior{place_cell(inside), &space_, std::log(0.01), std::nullopt};
  EXPECT_NEAR(std::exp(log_density(prior, inside)), 0.01 / (2.0 * std::numbers::pi), 1e-12);
  EXPECT_EQ(log_density(prior, pose_at(10.5, 5.5, 30.0)), -HUGE_VAL);
  EXPECT_EQ(log_density(prior, pose_at(9.5, 5.5, 45.0)), -HUGE_VAL);
  const Pose solid = pose_at(9.5, 6.5, 30.0);
  EXPECT_EQ(log_density(FlatPrior{place_cell(solid), &space_, 0.0, std::nullopt}, solid),
            -HUGE_VAL);
  const FlatPrior known{place_cell(inside), &space_, 0.0,
                        HeadingPrior{Angle::from_degrees(28.0), 2.0}};
  const double sigma = 2.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(log_density(known, inside), -0.5 - std::log(sigma * std::sqrt(2 * std::numbers::pi)),
              1e-9);
}

TEST(PoseBelief, IsADensityWithItsNormaliser) {
  const PoseBelief belief(with_equal_weights({pose_at(0, 0, 0)}), 0.2, 4.0);
  Random random(1);
  const double half_rad = Angle::from_degrees(60.0).radians();
  const int kDraws = 2000000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const Pose pose{random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5),
                    Angle::from_radians(random.uniform(-half_rad, half_rad))};
    sum += std::exp(belief.log_density(pose) + belief.log_normaliser());
  }
  EXPECT_NEAR(sum / kDraws * 25.0 * 2.0 * half_rad, 1.0, 0.05);
}

TEST(CellSample, KeepsWeightsAndFewOfWhatIsUnlikely) {
  ParticleSet set;
  for (int i = 0; i < 100; ++i) {
    set.poses.push_back(pose_at(0.5, 0.5, 5.0));
    set.weights.push_back(0.0098);
  }
  set.poses.push_back(pose_at(7.5, 0.5, 5.0));
  set.weights.push_back(0.02 - 1e-12);
  set.poses.push_back(pose_at(9.5, 0.5, 5.0));
  set.weights.push_back(1e-12);
  Random random(1);
  const CellSample sample = sample_cells(set, {1000, 0.5, 300, 1e-9, 10}, random);
  ASSERT_EQ(sample.cells.size(), 2U);
  EXPECT_EQ(sample.cells[0].end, 875U) << "in proportion to the root of 0.98";
  EXPECT_EQ(sample.cells[1].end - sample.cells[1].begin, 300U);
  const auto& weights = sample.particles.weights;
  EXPECT_NEAR(std::accumulate(weights.begin() + 875, weights.end(), 0.0), 0.02, 1e-6);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
  const CellSample one = sample_cells(set, {1000, 0.5, 300, 1e-9, 1}, random);
  ASSERT_EQ(one.cells.size(), 1U);
  EXPECT_EQ(one.particles.poses[0].x, 0.5);
}

// Two poses, each as likely; a metre ahead of the second one a disc of 0.4 m is too near to the
// box.
class BlockedWay : public Places {
 protected:
  PlaceFilter moved_filter(double radius_m) const {
    FilterSettings settings = robust_settings();
    settings.elsewhere_particles = 0;
    settings.places->robot_radius_m = radius_m;
    PlaceFilter filter(engine_, laser_, settings, 1);
    std::vector<Pose> both;
    for (int i = 0; i < 100; ++i) both.push_back(i < 50 ? here_ : before_the_box_);
    filter.take(with_equal_weights(both), &space_);
    filter.move(step_);
    return filter;
  }
  double share_of_the_free_way(const PlaceFilter& filter) const {
    return share_around(filter.particles(), moved(here_, step_));
  }

  const Pose here_ = pose_at(4.0, 5.0, 0.0), before_the_box_ = pose_at(7.7, 6.5, 0.0);
  const OdometryStep step_{Angle(), 1.0, Angle()};
};

TEST_F(BlockedWay, IsNotDrivenBeforeAScan) {
  const std::vector<double> blind(laser_.rays, laser_.max_range_m);
  const auto share_with = [&](double radius_m) {
    PlaceFilter filter = moved_filter(radius_m);
    filter.update(blind);
    return share_of_the_free_way(filter);
  };
  const double odds = share_with(0.0) / (1.0 - share_with(0.0));
  const double odds_of_a_disc = share_with(0.4) / (1.0 - share_with(0.4));
  EXPECT_NEAR(odds_of_a_disc / odds, 100.0, 5.0);
}

TEST_F(BlockedWay, IsNotDrivenBeforeAnotherMovement) {
  const auto share_with = [&](double radius_m) {
    PlaceFilter filter = moved_filter(radius_m);
    filter.move({});
    return share_of_the_free_way(filter);
  };
  EXPECT_NEAR(share_with(0.0), 0.5, 1e-9);
  EXPECT_NEAR(share_with(0.4), 1.0 / 1.01, 1e-3);
}

TEST_F(Places, TheFilterHoldsBothRoomsAtTheirHalves) {
  const Pose truth = pose_at(5.0, 5.0, 20.0);
  ExperimentSettings settings;
  settings.laser = laser_;
  settings.filter.particles = 2000;
  settings.filter.first_particles = 12000;
  settings.step_m = 0.3;
  settings.iterations = 6;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto run = run_experiment(space_, engine_, engine_, settings, truth, seed);
    ASSERT_TRUE(run);
    EXPECT_NEAR(run->iterations[0].truth_share, 0.5, 0.2) << seed;
    EXPECT_NEAR(run->iterations[5].truth_share, 0.5, 0.4) << seed;
  }
}

Journey journey_through(const ScanEngine& engine, const LaserModel& laser, const Pose& start) {
  Journey journey;
  Random random(5);
  Pose pose = start;
  for (int i = 0; i < 4; ++i) {
    const OdometryStep step{Angle::from_degrees(5.0), i == 0 ? 0.0 : 0.4, Angle()};
    if (i > 0) pose = moved(pose, step);
    journey.true_poses.push_back(pose);
    journey.steps.push_back(step);
    journey.scans.push_back(perceive(engine, pose, laser, {}, random));
  }
  return journey;
}

TEST_F(Places, ThatAreAlikeNoEvidenceTellsApart) {
  const Journey journey = journey_through(engine_, laser_, pose_at(5.0, 5.0, 60.0));
  Pose estimate = journey.true_poses.back();
  estimate.x += kNextRoom_m;
  const double share =
      evidence_for_truth(engine_, laser_, {}, journey, estimate, kRight_m, kRight_deg, 1);
  EXPECT_NEAR(share, 0.5, 0.2);
}

TEST_F(UnequalPlaces, EvidenceTellsApartWhateverTheFilterDid) {
  const Journey journey = journey_through(engine_, laser_, pose_at(5.0, 5.0, 60.0));
  Pose estimate = journey.true_poses.back();
  estimate.x += kNextRoom_m;
  EXPECT_GT(evidence_for_truth(engine_, laser_, {}, journey, estimate, kRight_m, kRight_deg, 1),
            kDecided);
}

TEST(CarriedAlong, ARigidMotionTakesAPathToAnother) {
  const Pose from = pose_at(3.0, 1.0, 10.0), to = pose_at(-2.0, 4.0, 100.0);
  const Pose carried = carried_along(pose_at(5.0, 1.0, 40.0), from, to);
  EXPECT_NEAR(carried.x, -2.0, 1e-12);
  EXPECT_NEAR(carried.y, 6.0, 1e-12);
  EXPECT_NEAR(carried.theta.degrees(), 130.0, 1e-9);
}

}  // namespace
}  // namespace mapwright::navcore
