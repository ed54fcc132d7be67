#include "navcore/logs/carmen_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mapwright::navcore {
namespace {

std::vector<RecordedScan> read(std::string_view text) {
  auto scans = read_carmen_log(text, "run.log");
  if (!scans) ADD_FAILURE() << scans.error().message;
  return scans ? *std::move(scans) : std::vector<RecordedScan>{};
}

std::string message_of(std::string_view text) {
  const auto scans = read_carmen_log(text, "run.log");
  return scans ? "no failure" : scans.error().message;
}

TEST(NoReturn, KnowsTheCodesAndNothingElse) {
  for (const double code : {81.83, 81.87, 81.90, 81.91, 32.76, 32.767, 50.0, 80.0, 0.0, -1.0}) {
    EXPECT_TRUE(is_no_return(code)) << code;
  }
  for (const double range : {81.82, 81.92, 32.75, 32.77, 49.99, 50.01, 8.19, 0.01, 79.5}) {
    EXPECT_FALSE(is_no_return(range)) << range;
  }
  EXPECT_TRUE(is_no_return(std::nan("")));
  EXPECT_TRUE(is_no_return(HUGE_VAL));
}

TEST(NoReturn, TheLasersOwnRangeDecidesWhereItIsKnown) {
  EXPECT_FALSE(is_no_return(50.0, 60.0));
  EXPECT_TRUE(is_no_return(60.0, 60.0));
  EXPECT_TRUE(is_no_return(0.0, 60.0));
}

TEST(CarmenLog, ReadsFlaserAmongOtherMessages) {
  const auto scans = read(
      "# CARMEN Logfile\n"
      "PARAM robot_frontlaser_offset 0.0 nohost 0\n"
      "ODOM 1 2 0.5 0 0 0 3.25 host 3.25\n"
      "FLASER 4 1.5 81.83 2 50 9 8 7 1 2 0.5 3.5 host 3.75\n"
      "\n"
      "FLASER 3 1 2 3 9 8 7 1.5 2 -0.5 4.5 host 4.75");
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].line, 4U);
  EXPECT_EQ(scans[0].ranges, (std::vector<double>{1.5, HUGE_VAL, 2.0, HUGE_VAL}));
  EXPECT_EQ(scans[0].odometry, (Pose{1.0, 2.0, Angle::from_radians(0.5)}));
  EXPECT_EQ(scans[0].time_s, 3.5);
  EXPECT_EQ(scans[1].line, 6U);
  EXPECT_EQ(scans[1].odometry.theta.radians(), -0.5);
}

TEST(CarmenLog, FlaserBeamsSpanHalfATurn) {
  const auto even = read("FLASER 4 1 1 1 1 0 0 0 0 0 0 1 h 1\n")[0].fan;
  EXPECT_NEAR(beam_direction(even, 0).degrees(), -90.0, 1e-12);
  EXPECT_NEAR(beam_direction(even, 3).degrees(), 45.0, 1e-12);
  const auto odd = read("FLASER 3 1 1 1 0 0 0 0 0 0 1 h 1\n")[0].fan;
  EXPECT_NEAR(beam_direction(odd, 1).degrees(), 0.0, 1e-12);
  EXPECT_NEAR(beam_direction(odd, 2).degrees(), 90.0, 1e-12);
}

TEST(CarmenLog, ReadsRobotlaserWithItsOwnFanAndRange) {
  const auto scans = read(
      "ROBOTLASER1 0 -1.5 3 0.5 30 0.01 0 3 1 30 50 2 7 7 "
      "4 5 0.25 4.5 5.5 0.125 0 0 0 0 0 12.5 host 12.75\r\n");
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(scans[0].ranges, (std::vector<double>{1.0, HUGE_VAL, HUGE_VAL}));
  EXPECT_NEAR(scans[0].fan.first.radians(), -1.375, 1e-12);
  EXPECT_EQ(scans[0].fan.step.radians(), 0.5);
  EXPECT_EQ(scans[0].odometry.x, 4.5);
  EXPECT_EQ(scans[0].time_s, 12.5);
}

TEST(CarmenLog, NamesTheLineOfAMistake) {
  EXPECT_EQ(message_of("# x\nFLASER 4 1 2\n"),
            "run.log:2: the line ends before the last of its ranges");
  EXPECT_EQ(message_of("FLASER 2 1 two 0 0 0 0 0 0 1 h 1\n"),
            "run.log:1: the last of its ranges: 'two' is not a number");
  EXPECT_EQ(message_of("FLASER -3 1 2\n"),
            "run.log:1: the number of ranges is no whole number from 0 to 100000");
  EXPECT_EQ(message_of("FLASER 1 1 0 0 0 0 0 0 1 h 1\n"),
            "run.log:1: a scan of fewer than 2 beams");
  EXPECT_EQ(message_of("FLASER 2 1 2 0 0 0 0 nan 0 1 h 1\n"),
            "run.log:1: the odometry is not finite");
  EXPECT_EQ(message_of("scan,t,odom_x\n"), "run.log:1: 'scan,t,odom_x' is no CARMEN message");
  EXPECT_EQ(message_of("ODOM 0 0 0\n"), "run.log: holds no scan (no FLASER, no ROBOTLASER1)");
}

TEST(CarmenLog, AWrongNumberOfRangesIsNoPose) {
  const std::string end = " 0 0 0 1 2 0.5 3.5 host 3.75\n";
  EXPECT_EQ(read("FLASER 3 1 1 1" + end).size(), 1U);
  EXPECT_EQ(read("FLASER 3 1 1 1 0 0 0 1 2 0.5 3.5\n").size(), 1U);  // without the host
  EXPECT_EQ(
      message_of("FLASER 3 1 1 1 1" + end),
      "run.log:1: 3 ranges and what follows them are 12 fields, but here are 13; is the number "
      "of ranges wrong?");
  EXPECT_EQ(
      message_of("FLASER 4 1 1 1" + end),
      "run.log:1: 4 ranges and what follows them are 13 fields, but here are 12; is the number "
      "of ranges wrong?");
}

TEST(CarmenLog, PassesAByteOrderMarkBy) {
  EXPECT_EQ(read("\xEF\xBB\xBF# CARMEN Logfile\nFLASER 2 1 1 0 0 0 0 0 0 1 h 1\n").size(), 1U);
}

TEST(CarmenLog, PassesNoBytesByThatAreNoText) {
  EXPECT_NE(message_of(std::string_view("\x00\x01\xff", 3)).find("run.log:1: "), std::string::npos);
}

}  // namespace
}  // namespace mapwright::navcore
