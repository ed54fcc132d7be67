// Recorded robots that are carried off.
#include "navcore/localization/kidnapping.hpp"

#include <gtest/gtest.h>

namespace mapwright::navcore {
namespace {

RecordedStep step_at(double time_s, const Pose& odometry, double reference_x) {
  RecordedStep step;
  step.scan.time_s = time_s;
  step.odometry = odometry;
  step.reference = Pose{reference_x, 0.0, Angle()};
  return step;
}

Pose pose_at(double x, double y, double deg) {
  return {x, y, Angle::from_degrees(deg)};
}

TEST(Splicing, OdometryAndClockGoOnAsIfNothingHadHappened) {
  const std::vector<RecordedStep> first{step_at(10, pose_at(0, 0, 0), 0),
                                        step_at(12, pose_at(1, 0, 90), 1)};
  const std::vector<RecordedStep> second{step_at(500, pose_at(7, 7, 180), 40),
                                         step_at(503, pose_at(6, 7, 170), 41)};
  const auto steps = spliced(first, second);
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[2].odometry, steps[1].odometry);
  // A metre ahead of where it then looks: along +y.
  EXPECT_NEAR(steps[3].odometry.x, 1.0, 1e-12);
  EXPECT_NEAR(steps[3].odometry.y, 1.0, 1e-12);
  EXPECT_NEAR(steps[3].odometry.theta.degrees(), 80.0, 1e-9);
  EXPECT_EQ(steps[2].scan.time_s, 14.0);
  EXPECT_EQ(steps[3].scan.time_s, 17.0);
  EXPECT_EQ(steps[3].reference->x, 41.0);
}

RecordedRun run_of(const std::string& pattern) {  // '+' right, '-' wrong; a metre a scan
  RecordedRun run;
  for (const char c : pattern) {
    RecordedIteration iteration;
    iteration.reference = Pose{static_cast<double>(run.iterations.size()), 0.0, Angle()};
    iteration.position_error_m = c == '+' ? 0.1 : 2.0;
    run.iterations.push_back(iteration);
  }
  return run;
}

TEST(JudgeKidnapping, CountsFromTheFirstScanElsewhere) {
  const auto verdict = judge_kidnapping(run_of("+++++---+++++++"), 5);
  EXPECT_TRUE(verdict.right_before);
  EXPECT_TRUE(verdict.recovered);
  EXPECT_EQ(verdict.scans, 4U);
  EXPECT_NEAR(verdict.way_m, 3.0, 1e-12);
  EXPECT_NEAR(verdict.carried_m, 1.0, 1e-12);
  EXPECT_EQ(judge_kidnapping(run_of("+++++++++++"), 5).scans, 1U);
  EXPECT_FALSE(judge_kidnapping(run_of("++++-++++++++"), 5).right_before);
  EXPECT_FALSE(judge_kidnapping(run_of("+++++-----------"), 5).recovered);
}

}  // namespace
}  // namespace mapwright::navcore
