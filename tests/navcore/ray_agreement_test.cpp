// The culled ray caster against every ray × every segment.
#include <gtest/gtest.h>

#include <cmath>

#include "converter/pipeline/convert.hpp"
#include "converter/rules/rule_reader.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/culled_ray_caster.hpp"
#include "tests/navcore/shapes.hpp"
#include "tests/support/data.hpp"

namespace mapwright::navcore {
namespace {

struct Disagreement {
  double worst_m = 0.0;
  std::size_t stopped = 0;  ///< rays that hit something
};

Disagreement compare(const Map& map, const LaserModel& laser, int poses, std::uint64_t seed) {
  const BruteForceRayCaster plain(map);
  const CulledRayCaster culled(map);
  Random random(seed);
  const Box area = map.border.box();
  std::vector<double> expected(laser.rays), actual(laser.rays);
  Disagreement result;
  for (int i = 0; i < poses; ++i) {
    const Pose pose{random.uniform(area.min_x, area.max_x), random.uniform(area.min_y, area.max_y),
                    Angle::from_degrees(random.uniform(-180, 180))};
    plain.cast(pose, laser, expected);
    culled.cast(pose, laser, actual);
    for (std::size_t j = 0; j < laser.rays; ++j) {
      result.worst_m = std::max(result.worst_m, std::abs(expected[j] - actual[j]));
      result.stopped += actual[j] < laser.max_range_m;
    }
  }
  return result;
}

void expect_agreement(const Map& map, std::uint64_t seed) {
  for (const LaserModel& laser : {LaserModel{131, 180, 15, 0.5}, LaserModel{131, 360, 30, 0.15},
                                  LaserModel{61, 90, 8, 1.2}, LaserModel{1, 180, 15, 0.3}}) {
    const auto result = compare(map, laser, 1000, seed);
    EXPECT_LE(result.worst_m, 1e-9) << laser.rays << " rays over " << laser.fov_deg;
    EXPECT_GT(result.stopped, 100U);
  }
}

Map converted(const std::filesystem::path& source) {
  converter::ConvertOptions options;
  options.sources = {source.string()};
  options.rules =
      converter::read_rules(std::string(converter::builtin_rules("auto")), "auto").value();
  return converter::convert(options).value().map.whole();
}

// 0.15 m above the ground a laser meets steps, kerbs and ramps.
void expect_agreement_of_real_map(const Map& map) {
  for (const double height_m : {0.5, 0.15}) {
    const auto result = compare(map, {131, 180, 15, height_m}, 1000, 7);
    EXPECT_LE(result.worst_m, 1e-9) << height_m;
    EXPECT_GT(result.stopped, 10000U);
  }
}

TEST(RayAgreement, OnTheSampleCampus) {
  expect_agreement_of_real_map(converted(test::project_file("samples/campus/campus.gpkg")));
}

TEST(RayAgreement, OnCampusNord) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/campus_nord_25831.gpkg");
  expect_agreement_of_real_map(converted(test::real_data("campus_nord/campus_nord_25831.gpkg")));
}

TEST(RayAgreement, OnAClutteredSquare) {
  expect_agreement(test::cluttered_square(1), 1);
}
TEST(RayAgreement, OnAnotherClutteredSquare) {
  expect_agreement(test::cluttered_square(2), 2);
}
TEST(RayAgreement, OnARectilinearTown) {
  expect_agreement(test::rectilinear_town(), 3);
}

// Whole metres and right angles: every ray runs along walls, through corners or along steps.
TEST(RayAgreement, OnTheGridLinesOfATown) {
  const Map map = test::rectilinear_town();
  const BruteForceRayCaster plain(map);
  const CulledRayCaster culled(map);
  const LaserModel laser{5, 360, 15, 0.5};
  std::vector<double> expected(laser.rays), actual(laser.rays);
  for (int x = 0; x <= 60; ++x) {
    for (int y = 0; y <= 60; ++y) {
      const Pose pose{static_cast<double>(x), static_cast<double>(y), Angle()};
      plain.cast(pose, laser, expected);
      culled.cast(pose, laser, actual);
      ASSERT_EQ(expected, actual) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace mapwright::navcore
