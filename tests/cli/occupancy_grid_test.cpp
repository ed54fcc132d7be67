// `mapwright export -o X.yaml`: occupancy grids for map servers.
#include <gtest/gtest.h>

#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using test::content;
using test::run;
using test::TemporaryFolder;

struct Image {
  std::size_t width = 0, height = 0;
  std::string cells;
  char at(std::size_t x, std::size_t row_from_top) const { return cells[row_from_top * width + x]; }
};

Image read_pgm(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string magic;
  int most = 0;
  Image image;
  in >> magic >> image.width >> image.height >> most;
  in.get();
  image.cells.assign(std::istreambuf_iterator<char>(in), {});
  EXPECT_EQ(magic, "P5");
  EXPECT_EQ(image.cells.size(), image.width * image.height);
  return image;
}

TEST(OccupancyGrid, FillsStairs) {
  const TemporaryFolder folder;
  const std::string map = folder.file(
      "m.txt",
      "border;0;6;6;0;#obstacle;1;5;4;step;#1;1;5;1;0.2;1;;#1;3;3;3;0.4;1;;#3;3;5;3;0.4;1;;#"
      "5;5;1;5;0;1;;#");
  ASSERT_EQ(run({"export", map, "-o", folder.path("g.yaml"), "--resolution", "0.5"}).status, 0);
  const Image grid = read_pgm(folder.path("g.pgm"));
  for (std::size_t x = 0; x < 12; ++x) {
    for (std::size_t row = 0; row < 12; ++row) {
      const bool is_within = x >= 2 && x < 10 && row >= 2 && row < 10;
      const bool is_away = x < 1 || x > 10 || row < 1 || row > 10;
      const char expected = is_within ? 0 : static_cast<char>(254);
      if (is_within || is_away) {
        EXPECT_EQ(grid.at(x, row), expected) << x << " " << row;
      }
    }
  }
}

TEST(OccupancyGrid, ShowsWallsInsidesAndWhatTheLaserSees) {
  const TemporaryFolder folder;
  const std::string map = folder.file(
      "m.txt",
      "border;-1;3;3;-1;#"
      "obstacle;1;1;4;box;#0.5;0.5;2.5;0.5;2;1;;#2.5;0.5;2.5;2.5;2;1;;#2.5;2.5;0.5;2.5;2;1;;#"
      "0.5;2.5;0.5;0.5;2;1;;#"
      "obstacle;2;2;1;kerb;#-0.5;-0.5;1.5;-0.5;0.2;1;;#");
  ASSERT_EQ(run({"export", map, "-o", folder.path("g.yaml"), "--resolution", "1"}).status, 0);
  const Image all = read_pgm(folder.path("g.pgm"));
  ASSERT_EQ(all.width, 4U);
  ASSERT_EQ(all.height, 4U);
  constexpr char kOccupied = 0, kFree = static_cast<char>(254), kUnknown = static_cast<char>(205);
  EXPECT_EQ(all.at(2, 1), kUnknown);
  EXPECT_EQ(all.at(1, 2), kOccupied);
  EXPECT_EQ(all.at(3, 0), kOccupied);
  EXPECT_EQ(all.at(0, 0), kFree);
  EXPECT_EQ(all.at(0, 3), kOccupied);
  EXPECT_EQ(all.at(3, 3), kFree);
  const std::string yaml = content(folder.path("g.yaml"));
  EXPECT_NE(yaml.find("origin: [-1, -1, 0.0]"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("image: \"g.pgm\""), std::string::npos) << yaml;
  const auto seen = run(
      {"export", map, "-o", folder.path("l.yaml"), "--resolution", "1", "--laser-height", "0.4"});
  ASSERT_EQ(seen.status, 0) << seen.err;
  EXPECT_EQ(read_pgm(folder.path("l.pgm")).at(0, 3), kFree);
  EXPECT_EQ(read_pgm(folder.path("l.pgm")).at(1, 2), kOccupied);
}

}  // namespace
}  // namespace mapwright
