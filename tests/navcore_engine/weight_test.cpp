// Weights from the same pass against the reference likelihood.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/ray_exactness.hpp"
#include "mapcore/random.hpp"
#include "navcore/rays/culled_ray_caster.hpp"
#include "tests/navcore_engine/engines.hpp"

namespace mapwright::navcore {
namespace {

const LikelihoodModel kModels[] = {
    report_likelihood(),
    {LikelihoodKind::kReport, 1.0, 0.1, 0.0, 0.05},  // exponents beyond double precision
    {LikelihoodKind::kReport, 1.0, 0.0, 0.0, 0.5},   // no uniform part at all
    {LikelihoodKind::kRobust, 1.0, 0.1, 0.05, 0.5},
    {LikelihoodKind::kRobust, 1.0, 3.0, 1.0, 0.07},
    {LikelihoodKind::kRobust, 0.5, 1e-3, 1e-6, 0.2},
};

std::vector<double> perceived_scan(const RayCaster& caster, const Pose& pose,
                                   const LaserModel& laser, std::uint64_t seed) {
  std::vector<double> scan(laser.rays);
  caster.cast(pose, laser, scan);
  Random random(seed);
  for (double& range : scan) {
    if (random.below(5) == 0) range *= random.uniform();  // somebody in the way
    range = std::clamp(range + random.normal(0.0, 0.05), 0.0, laser.max_range_m);
  }
  return scan;
}

// The reference works on exact ranges; what single precision does to Δ, and to Δ²/2σ², is allowed
// for beam by beam.
double allowed_error(const std::vector<double>& scan, std::span<const double> ranges,
                     const LikelihoodModel& model) {
  double sum = 0.0;
  for (std::size_t j = 0; j < scan.size(); ++j) {
    const double delta = std::abs(scan[j] - ranges[j]);
    sum += (delta * 2e-5 + delta * delta * 1e-6) / (model.sigma_m * model.sigma_m);
  }
  return 1e-3 + sum;
}

TEST(ScanEngineWeights, AgreeWithTheReference) {
  const Map map = bench::generate_campus(bench::kCampus100m);
  const CulledRayCaster exact(map);
  const LaserModel laser{61, 180.0, 15.0, 0.5};
  auto poses = bench::poses_everywhere(map, 300, 7);
  const auto scan = perceived_scan(exact, poses[0], laser, 8);
  for (int i = 0; i < 50; ++i) poses.push_back({poses[0].x + 0.01 * i, poses[0].y, poses[0].theta});
  std::vector<double> ranges(poses.size() * laser.rays), actual(poses.size());
  exact.cast_all(poses, laser, ranges);
  test::on_each_instruction_set(map, [&](const ScanEngine& engine) {
    for (const LikelihoodModel& model : kModels) {
      engine.weigh(scan, laser, model, poses, actual, 1);
      std::size_t compared = 0;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::span<const double> own(ranges.data() + i * laser.rays, laser.rays);
        const double expected = log_weight_factor(scan, own, model, laser.max_range_m);
        ASSERT_TRUE(std::isfinite(expected));
        // An edge that a ray grazes may be met or not: such poses are few.
        if (std::abs(actual[i] - expected) <= allowed_error(scan, own, model)) ++compared;
        ASSERT_TRUE(std::isfinite(actual[i]));
      }
      EXPECT_GE(compared, poses.size() - 2) << model.beta << ' ' << model.sigma_m;
    }
  });
}

TEST(ScanEngineWeights, SameBytesForAnyNumberOfThreads) {
  const Map map = bench::generate_campus({50.0, 130, 1});
  const LaserModel laser;
  const auto poses = bench::poses_everywhere(map, 2000, 1);
  const std::vector<double> scan(laser.rays, 4.0);
  test::on_each_instruction_set(map, [&](const ScanEngine& engine) {
    for (const LikelihoodModel& model : kModels) {
      std::vector<double> one(poses.size()), many(poses.size());
      engine.weigh(scan, laser, model, poses, one, 1);
      engine.weigh(scan, laser, model, poses, many, 3);
      EXPECT_EQ(one, many);
    }
  });
}

// A beam 15 m longer than the map says, without floor under it: exp(45000).
TEST(ScanEngineWeights, StayFiniteForTheWorstScan) {
  const Map map = bench::generate_campus({50.0, 130, 1});
  const LaserModel laser;
  const auto poses = bench::poses_everywhere(map, 100, 2);
  test::on_each_instruction_set(map, [&](const ScanEngine& engine) {
    for (const double range : {0.0, 15.0}) {
      const std::vector<double> scan(laser.rays, range);
      for (LikelihoodModel model : kModels) {
        model.sigma_m = 0.02;
        std::vector<double> weights(poses.size());
        engine.weigh(scan, laser, model, poses, weights, 1);
        for (const double weight : weights) ASSERT_TRUE(std::isfinite(weight));
      }
    }
  });
}

TEST(ScanEngineWeights, WithoutANormalPartTheReferenceAnswers) {
  const Map map = bench::generate_campus({50.0, 130, 1});
  const ScanEngine engine(map);
  const LaserModel laser;
  const auto poses = bench::poses_everywhere(map, 20, 3);
  const std::vector<double> scan(laser.rays, 2.0);
  const LikelihoodModel floors{LikelihoodKind::kRobust, 0.0, 1.0, 0.5, 0.1};
  std::vector<double> actual(poses.size()), expected(poses.size());
  engine.weigh(scan, laser, floors, poses, actual, 1);
  RayCastingWeigher(engine).weigh(scan, laser, floors, poses, expected, 1);
  EXPECT_EQ(actual, expected);
}

}  // namespace
}  // namespace mapwright::navcore
