// The report's ray casting, word for word, against every ray × every segment.
#include "bench/support/report_rays.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/ray_exactness.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"

namespace mapwright::bench {
namespace {

TEST(ReportRays, AgreeWithEverySegment) {
  const Map map = generate_campus({60.0, 300, 11});
  const navcore::BruteForceRayCaster plain(map);
  const ReportRays report(map);
  const auto poses = poses_everywhere(map, 150, 12);
  for (const navcore::LaserModel& laser :
       {navcore::LaserModel{131, 180.0, 15.0, 0.5}, navcore::LaserModel{61, 360.0, 25.0, 0.05},
        navcore::LaserModel{1, 180.0, 15.0, 1.2}}) {
    std::vector<double> expected(poses.size() * laser.rays), actual(expected.size());
    plain.cast_all(poses, laser, expected);
    report.cast_all(poses, laser, actual);
    std::size_t stopped = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(actual[i], expected[i], 1e-9) << i;
      stopped += expected[i] < laser.max_range_m ? 1 : 0;
    }
    EXPECT_GT(stopped, expected.size() / 10);
  }
}

}  // namespace
}  // namespace mapwright::bench
