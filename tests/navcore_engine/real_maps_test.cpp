// The scan engine on the project's samples and on the report's own site.
#include <gtest/gtest.h>

#include <string>

#include "bench/support/ray_exactness.hpp"
#include "converter/pipeline/convert.hpp"
#include "converter/rules/rule_reader.hpp"
#include "navcore/rays/culled_ray_caster.hpp"
#include "tests/navcore_engine/engines.hpp"
#include "tests/support/data.hpp"

namespace mapwright::navcore {
namespace {

Map converted(const std::filesystem::path& source) {
  converter::ConvertOptions options;
  options.sources = {source.string()};
  options.rules =
      converter::read_rules(std::string(converter::builtin_rules("auto")), "auto").value();
  return converter::convert(options).value().map.whole();
}

void expect_exact(const Map& map, std::size_t poses) {
  ASSERT_GT(segment_count(map), 50U);
  const CulledRayCaster reference(map);
  const auto where = bench::poses_everywhere(map, poses, 1);
  test::on_each_instruction_set(map, [&](const ScanEngine& engine) {
    for (const double height : {0.1, 0.5, 1.1}) {
      const LaserModel laser{181, 360.0, 15.0, height};
      const auto result = bench::measure_exactness(map, engine, reference, where, laser);
      EXPECT_EQ(result.wrong, 0U) << result.first_wrong;
      EXPECT_GT(result.stopped, poses);
    }
  });
}

TEST(ScanEngineExactness, OnTheSampleCampus) {
  expect_exact(converted(test::project_file("samples/campus/campus.gpkg")), 150);
}

TEST(ScanEngineExactness, OnCampusNord) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/campus_nord_25831.gpkg");
  expect_exact(converted(test::real_data("campus_nord/campus_nord_25831.gpkg")), 100);
}

}  // namespace
}  // namespace mapwright::navcore
