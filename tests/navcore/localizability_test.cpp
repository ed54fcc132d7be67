// The bound against maximum likelihood, twins against exhaustive search.
#include "navcore/localizability/localizability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "navcore/localizability/edge_information.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

TEST(BeamNoise, WithoutOcclusionIsGaussian) {
  const BeamNoise noise({0.05, 0.0}, 15.0);
  EXPECT_NEAR(noise.information_per_m2(), 400.0, 1e-3);
  EXPECT_NEAR(noise.distinction(0.1), 0.01 / (8.0 * 0.0025), 1e-12);
  EXPECT_EQ(noise.distinction(0.0), 0.0);
}

TEST(BeamNoise, OcclusionLimitsWhatABeamTells) {
  const BeamNoise noise({0.05, 0.1}, 15.0);
  EXPECT_LT(noise.information_per_m2(), 0.9 * 400.0);
  EXPECT_GT(noise.information_per_m2(), 0.8 * 400.0);
  double last = 0.0;
  for (double delta = 0.01; delta < 0.5; delta += 0.01) {
    EXPECT_GE(noise.distinction(delta), last);
    last = noise.distinction(delta);
  }
  EXPECT_NEAR(noise.distinction(0.5), noise.distinction(5.0), 0.05);
  EXPECT_GT(noise.echo_distinction(), noise.distinction(5.0));
  EXPECT_LT(noise.echo_distinction(), -std::log(0.1));
}

// Two Gaussians D standard deviations apart are mistaken with the probability Φ(−D/2).
TEST(ConfusionBounds, HoldTheTrueErrorOfGaussians) {
  const BeamNoise noise({0.05, 0.0}, 15.0);
  for (double d = 0.0; d < 6.0; d += 0.25) {
    const ConfusionBounds bounds = confusion_bounds(noise.distinction(0.05 * d));
    const double error = 0.5 * std::erfc(0.5 * d / std::numbers::sqrt2);
    EXPECT_LE(bounds.least, error + 1e-15);
    EXPECT_GE(bounds.most, error - 1e-15);
  }
}

/// A room with a bay, seen from where no edge hides anything.
Map bay() {
  return {{0, 10, 12, 0},
          {test::outline(1, {{0, 10}, {7, 10}, {7, 8}, {12, 8}, {12, 0}, {5, 0}, {4.5, 1}, {0, 2}},
                         3.0)}};
}

// Maximum likelihood by Gauss-Newton from the truth.
Pose most_likely(const GradientCaster& caster, const LaserModel& laser,
                 const std::vector<double>& scan, Pose pose) {
  std::vector<RangeGradient> there(laser.rays);
  for (int k = 0; k < 6; ++k) {
    caster.cast(pose, laser, there);
    const PoseInformation i = scan_information(there, 1.0);
    double bx = 0.0, by = 0.0, bt = 0.0;
    for (std::size_t j = 0; j < scan.size(); ++j) {
      const double delta = scan[j] - there[j].range_m;
      bx += delta * there[j].by_x;
      by += delta * there[j].by_y;
      bt += delta * there[j].by_theta;
    }
    const double d = i.xx * (i.yy * i.tt - i.yt * i.yt) - i.xy * (i.xy * i.tt - i.yt * i.xt) +
                     i.xt * (i.xy * i.yt - i.yy * i.xt);
    pose.x += ((i.yy * i.tt - i.yt * i.yt) * bx + (i.xt * i.yt - i.xy * i.tt) * by +
               (i.xy * i.yt - i.yy * i.xt) * bt) /
              d;
    pose.y += ((i.xt * i.yt - i.xy * i.tt) * bx + (i.xx * i.tt - i.xt * i.xt) * by +
               (i.xy * i.xt - i.xx * i.yt) * bt) /
              d;
    pose.theta = pose.theta + Angle::from_radians(((i.xy * i.yt - i.yy * i.xt) * bx +
                                                   (i.xy * i.xt - i.xx * i.yt) * by +
                                                   (i.xx * i.yy - i.xy * i.xy) * bt) /
                                                  d);
  }
  return pose;
}

TEST(AccuracyBound, IsReachedByMaximumLikelihood) {
  const Map map = bay();
  const GradientCaster caster(map);
  const LaserModel laser{131, 180, 15, 0.5};
  constexpr double kSigma_m = 0.02;
  constexpr int kRuns = 600;
  for (const Pose& truth :
       {Pose{6, 4, Angle::from_degrees(30)}, Pose{3, 6, Angle::from_degrees(60)},
        Pose{9, 3, Angle::from_degrees(-150)}}) {
    std::vector<RangeGradient> exact(laser.rays);
    caster.cast(truth, laser, exact);
    const AccuracyBound bound =
        accuracy_bound(scan_information(exact, gaussian_range_information(kSigma_m)));
    const Point u = unit_vector(bound.major_direction);
    Random random(4);
    double major = 0.0, minor = 0.0, turn = 0.0;
    for (int run = 0; run < kRuns; ++run) {
      std::vector<double> scan;
      for (const auto& beam : exact) scan.push_back(beam.range_m + random.normal(0.0, kSigma_m));
      const Pose estimate = most_likely(caster, laser, scan, truth);
      const Point error = estimate.position() - truth.position();
      major += dot(u, error) * dot(u, error) / kRuns;
      minor += cross(u, error) * cross(u, error) / kRuns;
      turn += std::pow((estimate.theta - truth.theta).radians(), 2) / kRuns;
    }
    // 600 runs tell a standard deviation to 3 %.
    EXPECT_NEAR(std::sqrt(major) / bound.major_m, 1.0, 0.12);
    EXPECT_NEAR(std::sqrt(minor) / bound.minor_m, 1.0, 0.12);
    EXPECT_NEAR(std::sqrt(turn) / bound.heading_rad, 1.0, 0.12);
  }
}

// A board before a far wall: its edges tell the position along it, its face does not.
TEST(EdgeInformation, TellsWhatAPlainFaceDoesNot) {
  const Map map{{-50, 50, 50, -50},
                {test::wall(1, {-2, 5}, {2, 5}, 3.0), test::wall(2, {-40, 9}, {40, 9}, 3.0)}};
  const GradientCaster caster(map);
  const LaserModel laser{131, 90, 30, 0.5};
  const Pose pose{0.3, 0, Angle::from_degrees(90)};
  std::vector<RangeGradient> scan(laser.rays);
  caster.cast(pose, laser, scan);
  const BeamNoise noise({0.05, 0.0}, laser.max_range_m);
  const HeadingAccuracy accuracy = heading_accuracy(scan, pose, laser, noise);
  EXPECT_TRUE(std::isinf(accuracy.bound.major_m));
  // Two edges, each to δ/√12 at 5.4 m.
  const double step_rad = 90.0 / 130.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(accuracy.with_edges.major_m, 5.4 * step_rad / std::sqrt(12.0 * 2.0), 0.01);
}

TEST(AccuracyField, HeadingsThatShareBeamsAreThoseCastAlone) {
  const Map map = test::cluttered_square(1);
  const GradientCaster caster(map);
  AccuracySettings settings;
  const auto headings = headings_looked_at(settings);
  ASSERT_EQ(headings.size(), 16U);
  const Point place{20, 20};
  const auto all = accuracy_at(caster, {&place, 1}, settings, 1);
  double worst = 0.0;
  for (const double heading : headings) {
    AccuracySettings one = settings;
    one.heading_deg = heading;
    const auto alone = accuracy_at(caster, {&place, 1}, one, 1);
    worst = std::max(worst, alone[0].worst.bound.major_m);
    EXPECT_NEAR(heading, 360.0 / 16 * std::round(heading / 22.5), 0.7);
  }
  EXPECT_NEAR(all[0].worst.bound.major_m, worst, 1e-6 * worst);
}

/// Two niches on a hall, alike but for `difference_m` in width.
Map comb(double difference_m) {
  const double right = 24 - difference_m;
  std::vector<Point> outline{{0, 0},  {26, 0}, {26, 5}, {right, 5}, {right, 13}, {20, 13},
                             {20, 5}, {6, 5},  {6, 13}, {2, 13},    {2, 5},      {0, 5}};
  std::reverse(outline.begin(), outline.end());
  return {{0, 13, 26, 0}, {test::outline(1, outline, 3.0)}};
}

LocalizabilitySettings small_settings() {
  LocalizabilitySettings settings;
  settings.cell_m = 1.0;
  settings.twin_spacing_m = 1.0;
  settings.heading_deg = 90.0;
  settings.robot_radius_m = 0.2;
  return settings;
}

// The least distinction to any place of a fine grid with the same heading.
double exhaustive_nats(const GradientCaster& caster, const FreeSpace& space, const Pose& pose,
                       const LocalizabilitySettings& settings,
                       const std::vector<std::pair<Pose, std::vector<RangeGradient>>>& others,
                       const BeamNoise& noise) {
  TwinSettings twins;
  twins.compass_sigma_deg = settings.compass_sigma_deg;
  std::vector<RangeGradient> here(settings.laser.rays);
  caster.cast(pose, settings.laser, here);
  double least = HUGE_VAL;
  for (const auto& [other, scan] : others) {
    if (distance(other.position(), pose.position()) <= settings.apart_m) continue;
    if (!space.is_free(other.position(), settings.robot_radius_m)) continue;
    least = std::min(least, distinction_nats(here, scan, pose, other, twins, noise));
  }
  return least;
}

TEST(Twins, AreThoseOfAnExhaustiveSearch) {
  const Map map = comb(0.02);
  const FreeSpace space(map);
  const GradientCaster caster(map);
  const LocalizabilitySettings settings = small_settings();
  const auto field = localizability_field(map, space, settings);
  const BeamNoise noise(settings.noise, settings.laser.max_range_m);
  std::vector<std::pair<Pose, std::vector<RangeGradient>>> others;
  for (double x = 0.1; x < 26.0; x += 0.1) {
    for (double y = 0.1; y < 14.0; y += 0.1) {
      if (!space.is_free({x, y}, settings.robot_radius_m)) continue;
      others.push_back({{x, y, Angle::from_degrees(90)}, std::vector<RangeGradient>(131)});
      caster.cast(others.back().first, settings.laser, others.back().second);
    }
  }
  int confusable = 0;
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    const Point p = field.grid.center(i);
    if (field.stands[i] == 0 || p.y < 6.0) continue;  // the niches
    const double least = exhaustive_nats(caster, space, {p.x, p.y, Angle::from_degrees(90)},
                                         settings, others, noise);
    if (least > 8.0 || field.accuracy[i].worst.with_edges.major_m > 0.5) continue;
    ++confusable;
    ASSERT_TRUE(field.twins[i].worst.has_value()) << p.x << ' ' << p.y << ' ' << least;
    EXPECT_LE(field.twins[i].worst->nats, least + 0.02) << p.x << ' ' << p.y;
  }
  EXPECT_GT(confusable, 20);
}

TEST(Twins, ADifferenceOfTenDeviationsTellsPlacesApart) {
  const Map map = comb(0.5);
  const auto field = localizability_field(map, FreeSpace(map), small_settings());
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    const Point p = field.grid.center(i);
    if (p.y < 7.0) continue;
    EXPECT_LT(field.worst_risk(i), 1e-3) << p.x << ' ' << p.y;
  }
}

TEST(LocalizabilityField, DoesNotDependOnThreads) {
  const Map map = comb(0.02);
  const FreeSpace space(map);
  LocalizabilitySettings settings = small_settings();
  settings.heading_deg.reset();
  settings.compass_sigma_deg.reset();
  settings.threads = 1;
  const auto one = localizability_field(map, space, settings);
  settings.threads = 3;
  const auto three = localizability_field(map, space, settings);
  for (std::size_t i = 0; i < one.grid.size(); ++i) {
    ASSERT_EQ(one.accuracy[i].worst.bound.major_m, three.accuracy[i].worst.bound.major_m);
    ASSERT_EQ(one.worst_risk(i), three.worst_risk(i));
  }
}

}  // namespace
}  // namespace mapwright::navcore
