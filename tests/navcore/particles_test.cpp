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

// Two places, the first with most of the weight.
ParticleSet two_places(double first_weight) {
  ParticleSet set;
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const bool first = i % 2 == 0;
    set.poses.push_back({(first ? 10.0 : 40.0) + random.uniform(0.1, 0.9), 5.5, Angle()});
    set.weights.push_back((first ? first_weight : 1.0 - first_weight) / 100.0);
  }
  return set;
}

struct Drawn {
  std::size_t count = 0;
  double weight = 0.0;
};

Drawn drawn_beyond(const ParticleSet& set, const Sample& sample, double x) {
  Drawn result;
  for (std::size_t k = 0; k < sample.indices.size(); ++k) {
    if (set.poses[sample.indices[k]].x < x) continue;
    ++result.count;
    result.weight += sample.weights[k];
  }
  return result;
}

TEST(SampleByPlace, KeepsAPlaceThatByWeightWouldDieOut) {
  const ParticleSet set = two_places(1.0 - 1e-6);
  Random random(1);
  const Sample sample = sample_by_place(set, 5000, 0.5, random);
  const Drawn faint = drawn_beyond(set, sample, 20.0);
  EXPECT_NEAR(static_cast<double>(faint.count), 5000.0 * 1e-3, 1.0) << "1e-6 to the power 1/2";
  EXPECT_NEAR(faint.weight, 1e-6, 2.5e-7) << "and its particles weigh what the place did";
  EXPECT_NEAR(std::accumulate(sample.weights.begin(), sample.weights.end(), 0.0), 1.0, 1e-12);
}

TEST(SampleByPlace, StandsForTheSameDistribution) {
  const ParticleSet set = two_places(0.97);
  double mean = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    mean += drawn_beyond(set, sample_by_place(set, 50, 0.5, random), 20.0).weight / 200.0;
  }
  EXPECT_NEAR(mean, 0.03, 0.002);
}

TEST(SampleByPlace, ByWeightAloneAtPowerOne) {
  const ParticleSet set = two_places(0.9);
  Random random(1);
  const Sample sample = sample_by_place(set, 1000, 1.0, random);
  EXPECT_NEAR(static_cast<double>(drawn_beyond(set, sample, 20.0).count), 100.0, 1.0);
  for (const double weight : sample.weights) EXPECT_DOUBLE_EQ(weight, 1e-3);
}

TEST(SampleByPlace, NamesTheParticlesOfTheSamePlace) {
  const ParticleSet set = two_places(0.75);
  Random random(1);
  const Sample sample = sample_by_place(set, 400, 0.5, random);
  ASSERT_EQ(sample.kin.size(), 400U);
  for (std::size_t k = 0; k < sample.kin.size(); ++k) {
    const auto [begin, end] = sample.kin[k];
    ASSERT_TRUE(begin <= k && k < end && end <= 400U);
    for (std::size_t other = begin; other < end; ++other) {
      EXPECT_LT(std::abs(set.poses[sample.indices[k]].x - set.poses[sample.indices[other]].x), 1.0);
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
