// Logs and odometry tables as files.
#include "cli/support/log_files.hpp"

#include <gtest/gtest.h>

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include "cli/support/error.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright::test {
namespace {

const std::string kLog =
    "FLASER 2 1 2 0 0 0 0 0 0 1 host 1\n"
    "FLASER 2 1 81.83 0 0 0 0.5 0 0 2 host 2\n";

std::string zipped(const std::string& text) {
  std::string bytes;
  boost::iostreams::filtering_ostream out;
  out.push(boost::iostreams::gzip_compressor());
  out.push(boost::iostreams::back_inserter(bytes));
  out << text;
  out.reset();
  return bytes;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const cli::Error& error) {
    EXPECT_EQ(error.status(), cli::ExitStatus::kInput);
    return error.what();
  }
  return "no failure";
}

TEST(LogFile, PlainAndGzippedAreTheSame) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {kLog, zipped(kLog)}) {
    const auto scans = cli::read_log_file(folder.file("run.log", bytes));
    ASSERT_EQ(scans.size(), 2U);
    EXPECT_EQ(scans[1].odometry.x, 0.5);
  }
}

TEST(LogFile, ACutGzipFileIsAnError) {
  const TemporaryFolder folder;
  const std::string bytes = zipped(kLog);
  const auto path = folder.file("run.log.gz", bytes.substr(0, bytes.size() - 6));
  EXPECT_EQ(message_of([&] { cli::read_log_file(path); }),
            path + ": is cut short or damaged: it is not gzip data to its end");
}

TEST(LogFile, MistakesHaveFileAndLine) {
  const TemporaryFolder folder;
  const auto path = folder.file("run.log", kLog + "FLASER 2 1\n");
  EXPECT_EQ(message_of([&] { cli::read_log_file(path); }),
            path + ":3: the line ends before the last of its ranges");
}

TEST(OdometryFile, ReadsWithAndWithoutReference) {
  const TemporaryFolder folder;
  const auto plain = cli::read_odometry_file(
      folder.file("a.csv", "scan,t,odom_x,odom_y,odom_theta\n0,1,2,3,0.5\n1,2,2.5,3,0.25\n"), 2);
  EXPECT_EQ(plain[1].time_s, 2.0);
  EXPECT_EQ(plain[1].odometry, (Pose{2.5, 3.0, Angle::from_radians(0.25)}));
  EXPECT_FALSE(plain[1].reference);
  const auto with_reference = cli::read_odometry_file(
      folder.file("b.csv",
                  "scan,t,odom_x,odom_y,odom_theta,ref_x,ref_y,ref_theta\n0,1,2,3,0.5,4,5,0.75\n"),
      1);
  ASSERT_TRUE(with_reference[0].reference);
  EXPECT_EQ(*with_reference[0].reference, (Pose{4.0, 5.0, Angle::from_radians(0.75)}));
  const auto without_heading =
      cli::read_odometry_file(folder.file("c.csv", "0,1,2,3,0.5,4,5,0.75\n"), 1);
  EXPECT_TRUE(without_heading[0].reference);
}

TEST(OdometryFile, HalfAReferenceIsAMistake) {
  const TemporaryFolder folder;
  const auto path =
      folder.file("a.csv", "scan,t,odom_x,odom_y,odom_theta,ref_x,ref_y\n0,1,2,3,0.5,4,5\n");
  EXPECT_EQ(message_of([&] { cli::read_odometry_file(path, 1); }),
            path + ":1: field 1: no column 'ref_theta', which belongs to the others of its kind");
}

TEST(OdometryFile, MustFitTheLog) {
  const TemporaryFolder folder;
  const auto path =
      folder.file("a.csv", "scan,t,odom_x,odom_y,odom_theta\n0,1,2,3,0.5\n2,2,2,3,0\n");
  EXPECT_NE(message_of([&] { cli::read_odometry_file(path, 2); }).find("a.csv:3: "),
            std::string::npos);
  EXPECT_NE(message_of([&] { cli::read_odometry_file(path, 3); }).find("2 rows"),
            std::string::npos);
}

TEST(LogFile, ReadsTheRealLogs) {
  MAPWRIGHT_REQUIRE_REAL_DATA("3_robot/logs");
  const auto scans = cli::read_log_file(real_data("3_robot/logs/intel-corrected.log.gz").string());
  ASSERT_EQ(scans.size(), 910U);
  EXPECT_EQ(scans[0].ranges.size(), 180U);
  const auto rows =
      cli::read_odometry_file(real_data("3_robot/derived/intel.odom_ref.csv").string(), 910);
  EXPECT_TRUE(rows[909].reference);
}

}  // namespace
}  // namespace mapwright::test
