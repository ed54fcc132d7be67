#include "navcore/localization/particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "navcore/localization/pose_estimate.hpp"

namespace mapwright::navcore {
namespace {

TEST(Particles, EffectiveSizeCountsEquallyWeightedOnes) {
  EXPECT_DOUBLE_EQ(effective_size(std::vector<double>{0.25, 0.25, 0.25, 0.25}), 4.0);
  EXPECT_DOUBLE_EQ(effective_size(std::vector<double>{1.0, 0.0, 0.0}), 1.0);
}

TEST(Particles, WeightsAreMultipliedAndSumUpToOne) {
  std::vector<double> weights{0.5, 0.25, 0.25};
  EXPECT_TRUE(multiply_weights(weights, std::vector<double>{0.0, std::log(2.0), std::log(4.0)}));
  EXPECT_NEAR(weights[0], 0.25, 1e-15);
  EXPECT_NEAR(weights[1], 0.25, 1e-15);
  EXPECT_NEAR(weights[2], 0.5, 1e-15);
}

TEST(Particles, WeightsNeverUnderflowAltogether) {
  std::vector<double> weights{0.5, 0.5};
  EXPECT_TRUE(multiply_weights(weights, std::vector<double>{-100000.0, -100001.0}));
  EXPECT_NEAR(weights[0] / weights[1], std::exp(1.0), 1e-12);
}

TEST(Particles, AnImpossibleScanLeavesTheWeightsAlone) {
  std::vector<double> weights{0.75, 0.25, 0.0};
  EXPECT_FALSE(multiply_weights(weights, std::vector<double>{-HUGE_VAL, -HUGE_VAL, 0.0}));
  EXPECT_EQ(weights, (std::vector<double>{0.75, 0.25, 0.0}));
}

TEST(LowVarianceSample, DrawsEachByItsShareRoundedUpOrDown) {
  Random random(1);
  std::vector<double> weights(97);
  for (double& w : weights) w = random.uniform();
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= sum;
  for (int trial = 0; trial < 100; ++trial) {
    const auto drawn = low_variance_sample(weights, 1000, random);
    EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
      const auto count = static_cast<double>(std::count(drawn.begin(), drawn.end(), i));
      EXPECT_LE(std::abs(count - 1000 * weights[i]), 1.0 + 1e-9);
    }
  }
}

TEST(LowVarianceSample, NeverDrawsWithoutWeight) {
  Random random(2);
  for (const auto i : low_variance_sample(std::vector<double>{0.0, 1.0, 0.0}, 50, random)) {
    EXPECT_EQ(i, 1U);
  }
}

ParticleSet two_modes(double first_share) {
  Random random(7);
  ParticleSet set;
  for (int i = 0; i < 1000; ++i) {
    const bool first = i % 2 == 0;
    const Point at = first ? Point{10, 10} : Point{30, -5};
    const Angle heading =
        Angle::from_degrees(first ? 179.5 : 40.0) + Angle::from_degrees(random.normal(0, 2));
    set.poses.push_back({random.normal(at.x, 0.1), random.normal(at.y, 0.1), heading.wrapped()});
    set.weights.push_back((first ? first_share : 1 - first_share) / 500);
  }
  return set;
}

TEST(PoseEstimate, IsTheHeaviestModeNotTheMeanOfAll) {
  const PoseEstimate estimate = estimate_pose(two_modes(0.6));
  EXPECT_NEAR(estimate.pose.x, 10, 0.02);
  EXPECT_NEAR(estimate.pose.y, 10, 0.02);
  EXPECT_NEAR((estimate.pose.theta - Angle::from_degrees(179.5)).wrapped().degrees(), 0, 0.5)
      << "the mean of headings on both sides of 180°";
  EXPECT_NEAR(estimate.mode_share, 0.6, 1e-9);
  EXPECT_NEAR(estimate.mode_spread_m, 0.1 * std::sqrt(2.0), 0.01);
  EXPECT_NEAR(estimate.mode_heading_spread.degrees(), 2.0, 0.2);
  EXPECT_NEAR(estimate.spread_m, std::sqrt(0.4) * 25.0, 0.1);
  EXPECT_NEAR(estimate_pose(two_modes(0.4)).pose.x, 30, 0.02);
}

TEST(PoseEstimate, OfOneParticleIsThatParticle) {
  const Pose pose{-3.3, 4.4, Angle::from_degrees(-120)};
  const PoseEstimate estimate = estimate_pose(with_equal_weights({pose}));
  EXPECT_NEAR(estimate.pose.x, pose.x, 1e-12);
  EXPECT_NEAR(estimate.pose.y, pose.y, 1e-12);
  EXPECT_NEAR(estimate.pose.theta.degrees(), -120, 1e-9);
  EXPECT_EQ(estimate.mode_share, 1.0);
  EXPECT_NEAR(estimate.spread_m, 0.0, 1e-12);
}

}  // namespace
}  // namespace mapwright::navcore
