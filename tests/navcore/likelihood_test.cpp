#include "navcore/localization/likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mapwright::navcore {
namespace {

constexpr double kRange_m = 15.0;

double density(double delta, double sigma_m) {
  return std::exp(-delta * delta / (2 * sigma_m * sigma_m)) / (sigma_m * std::sqrt(2 * M_PI));
}

TEST(ReportLikelihood, IsEquations4To6) {
  const std::vector<double> perceived{5.0, 4.0, 3.2, 15.0};
  const std::vector<double> synthetic{5.0, 6.0, 3.0, 15.0};  // Δ = 0, −2, 0.2, 0
  const LikelihoodModel model = report_likelihood();
  const double level = 0.1 / kRange_m;
  const double sum =
      2.0 / (density(0, 0.5) + level) + 1.0 / (density(2, 0.5) + level) + 1.0 / density(0.2, 0.5);
  EXPECT_NEAR(log_weight_factor(perceived, synthetic, model, kRange_m), std::log(1.0 / sum), 1e-12);
}

TEST(ReportLikelihood, StaysFiniteWhereThePlainSumOverflows) {
  LikelihoodModel model = report_likelihood();
  model.sigma_m = 0.05;  // exp(14² / (2 · 0.05²)) is far beyond double
  const std::vector<double> perceived{15.0, 5.0}, synthetic{1.0, 5.0};
  const double expected = -14.0 * 14.0 / (2 * 0.05 * 0.05) + std::log(density(0, 0.05));
  EXPECT_NEAR(log_weight_factor(perceived, synthetic, model, kRange_m), expected, 1e-6);
}

TEST(ReportLikelihood, WithoutUniformPartPunishesShortBeamsLikeLongOnes) {
  LikelihoodModel model = report_likelihood();
  model.beta = 0.0;
  model.sigma_m = 0.05;
  const std::vector<double> near{1.0}, far{14.0};
  const double shorter = log_weight_factor(near, far, model, kRange_m);
  EXPECT_TRUE(std::isfinite(shorter));
  EXPECT_DOUBLE_EQ(shorter, log_weight_factor(far, near, model, kRange_m));
}

TEST(RobustLikelihood, IsTheProductOfBeamsWithAFloorOnBothSides) {
  const std::vector<double> perceived{5.0, 4.0, 9.0}, synthetic{5.0, 6.0, 3.0};
  const LikelihoodModel model{LikelihoodKind::kRobust, 1.0, 2.0, 0.5, 0.25};
  const double expected = std::log(density(0, 0.25) + 2.0 / kRange_m) +
                          std::log(density(2, 0.25) + 2.0 / kRange_m) +
                          std::log(density(6, 0.25) + 0.5 / kRange_m);
  EXPECT_NEAR(log_weight_factor(perceived, synthetic, model, kRange_m), expected, 1e-12);
}

TEST(RobustLikelihood, NeitherOverflowsNorUnderflowsOverManyBeams) {
  const std::vector<double> perceived(1000, 15.0), wrong(1000, 0.0);
  const LikelihoodModel model{LikelihoodKind::kRobust, 1.0, 0.1, 0.1, 0.001};
  EXPECT_NEAR(log_weight_factor(perceived, wrong, model, kRange_m), 1000 * std::log(0.1 / kRange_m),
              1e-8);
  EXPECT_NEAR(log_weight_factor(perceived, perceived, model, kRange_m),
              1000 * std::log(density(0, 0.001) + 0.1 / kRange_m), 1e-8);
}

}  // namespace
}  // namespace mapwright::navcore
