// Trials in numbers, and the bound they are set against.
#include "navcore/localization/trial_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "navcore/localization/sequential_bound.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

// Iterations that claim `shares` and are off by `errors_m`.
ExperimentRun run_of(const std::vector<double>& shares, const std::vector<double>& errors_m) {
  ExperimentRun run;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    IterationRecord record;
    record.n = i + 1;
    record.estimate.mode_share = shares[i];
    record.claim = shares[i];
    record.position_error_m = errors_m[i];
    record.believes = believes_converged(record.estimate);
    run.iterations.push_back(record);
  }
  return run;
}

TEST(TrialSummary, SetsWhatTheFilterClaimsAgainstHowOftenItIsRight) {
  const std::vector<ExperimentRun> runs{run_of({0.3, 0.97, 1.0, 1.0}, {9.0, 9.0, 0.1, 0.1}),
                                        run_of({0.96, 0.6, 0.5, 0.99}, {0.2, 0.1, 2.0, 0.4})};
  const TrialSummary summary = summarize(runs);
  ASSERT_EQ(summary.reliability.size(), 5U);
  EXPECT_EQ(summary.reliability[0].iterations, 1U);
  EXPECT_EQ(summary.reliability[1].iterations, 2U) << "0.5 belongs to its own line";
  EXPECT_EQ(summary.reliability[1].right, 1U);
  EXPECT_EQ(summary.reliability[2].iterations, 0U);
  EXPECT_DOUBLE_EQ(summary.reliability[3].mean_share, 0.965);
  EXPECT_EQ(summary.reliability[3].right, 1U);
  EXPECT_EQ(summary.reliability[4].iterations, 3U);
  EXPECT_EQ(summary.reliability[4].right, 3U);
  EXPECT_EQ(summary.sure, 5U);
  EXPECT_EQ(summary.sure_right, 4U);
}

TEST(TrialSummary, TellsLostPlacesFromThoseAlike) {
  const auto wrong = [](double evidence) {
    ExperimentRun run = run_of({1.0, 1.0}, {9.0, 9.0});
    run.truth_evidence = evidence;
    return run;
  };
  EXPECT_TRUE(wrong(0.951).lost());
  EXPECT_FALSE(wrong(0.949).lost());
  EXPECT_FALSE(run_of({1.0, 1.0}, {9.0, 0.1}).lost()) << "right at the end";
  const std::vector<ExperimentRun> runs{wrong(0.99), wrong(0.5), wrong(0.0)};
  const TrialSummary summary = summarize(runs);
  EXPECT_EQ(summary.depleted, 1U);
  EXPECT_EQ(summary.alike, 2U);
  EXPECT_EQ(summary.mistaken, 3U);
}

constexpr PoseInformation kStart{100.0, 0.0, 100.0, 0.0, 0.0, 400.0};  // 0.1 m, 0.05 rad

TEST(SequentialBound, AWayWithoutScansIsTheCovarianceOfOdometry) {
  const OdometryNoise noise{0.05, 0.01, 0.03, 0.01};
  const OdometryStep step{Angle::from_degrees(20), 1.5, Angle::from_degrees(-5)};
  const Pose from{3.0, 4.0, Angle::from_degrees(40)};
  SequentialBound bound(kStart);
  bound.move(from, step, noise);
  const AccuracyBound actual = accuracy_bound(bound.information());
  // The same by drawing: x, y of many ends.
  Random random(1);
  const int kDraws = 200000;
  double squares = 0.0, turns = 0.0;
  const Pose end = moved(from, step);
  for (int i = 0; i < kDraws; ++i) {
    const Pose start{from.x + random.normal(0.0, 0.1), from.y + random.normal(0.0, 0.1),
                     from.theta + Angle::from_radians(random.normal(0.0, 0.05))};
    const Pose drawn = moved(start, perturbed(step, noise, random));
    squares += squared_length(drawn.position() - end.position());
    turns += std::pow((drawn.theta - end.theta).wrapped().radians(), 2);
  }
  EXPECT_NEAR(position_bound_m(actual), std::sqrt(squares / kDraws), 0.002);
  EXPECT_NEAR(actual.heading_rad, std::sqrt(turns / kDraws), 0.0005);
}

TEST(SequentialBound, ScansAddUpAndPerfectOdometryLosesNothing) {
  SequentialBound bound(PoseInformation{});
  EXPECT_TRUE(std::isinf(position_bound_m(accuracy_bound(bound.information()))));
  for (int i = 0; i < 4; ++i) {
    bound.look(kStart);
    bound.move({1, 2, Angle()}, {Angle(), 0.0, Angle()}, {0, 0, 0, 0});
  }
  EXPECT_NEAR(accuracy_bound(bound.information()).major_m, 0.05, 1e-9);
  EXPECT_NEAR(accuracy_bound(bound.information()).heading_rad, 0.025, 1e-9);
}

TEST(SequentialBound, FollowsARunAndFallsBelowWhatTheStartTold) {
  const Map map{{0, 20, 20, 0},
                {test::wall(1, {1, 1}, {1, 19}, 2), test::wall(2, {1, 19}, {19, 19}, 2),
                 test::wall(3, {19, 19}, {19, 1}, 2), test::wall(4, {19, 1}, {1, 1}, 2)}};
  ExperimentSettings settings;
  settings.start_known = true;
  ExperimentRun run = run_of({1, 1, 1}, {0.01, 0.02, 0.02});
  for (std::size_t i = 0; i < 3; ++i) {
    run.iterations[i].true_pose = {4.0 + static_cast<double>(i), 6.0, Angle::from_degrees(45)};
    run.iterations[i].step = {Angle::from_degrees(-45), i == 0 ? 0.0 : 1.0,
                              Angle::from_degrees(45)};
  }
  const auto bounds = sequential_bounds(GradientCaster(map), settings, run);
  ASSERT_EQ(bounds.size(), 3U);
  EXPECT_LT(position_bound_m(bounds[0]), 0.02) << "0.05 m over many of 131 beams";
  EXPECT_LT(position_bound_m(bounds[2]), position_bound_m(bounds[0]));
  const std::vector<std::vector<AccuracyBound>> all_bounds{bounds};
  const auto summary = summarize_bounds(std::vector{run}, all_bounds);
  ASSERT_TRUE(summary);
  EXPECT_NEAR(summary->rms_error_m, std::sqrt(0.0009 / 3.0), 1e-12);
  EXPECT_DOUBLE_EQ(summary->error_m.median, 0.02);
  settings.laser_noise.occlusion = 0.5;
  const auto occluded = sequential_bounds(GradientCaster(map), settings, run);
  EXPECT_GT(position_bound_m(occluded[1]), position_bound_m(bounds[1]));
}

}  // namespace
}  // namespace mapwright::navcore
