// Line maps and grids become robot maps.
#include <gtest/gtest.h>

#include <algorithm>

#include "converter/importers/grid_description.hpp"
#include "converter/importers/imported_map.hpp"
#include "converter/importers/outlines.hpp"
#include "converter/importers/ring_simplification.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/random.hpp"

namespace mapwright::converter {
namespace {

// '#' occupied, '.' free, '?' unknown; the first line is the top.
OccupancyGrid drawn(const std::vector<std::string>& lines) {
  OccupancyGrid grid{lines[0].size(), lines.size(), 1.0, {}, {}};
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    for (const char c : *line) {
      grid.cells.push_back(c == '#' ? Cell::kOccupied : c == '?' ? Cell::kUnknown : Cell::kFree);
    }
  }
  return grid;
}

OccupancyGrid random_grid(std::uint64_t seed, std::size_t size, double occupied) {
  Random random(seed);
  OccupancyGrid grid{size, size, 1.0, {}, {}};
  for (std::size_t i = 0; i < size * size; ++i) {
    grid.cells.push_back(random.uniform() < occupied ? Cell::kOccupied : Cell::kFree);
  }
  return grid;
}

bool is_inside(const std::vector<std::vector<Point>>& rings, Point p) {
  const auto holds = [&](const auto& ring) { return side_of_ring(ring, p) == PointSide::kInside; };
  return std::count_if(rings.begin(), rings.end(), holds) % 2 == 1;
}

void expect_simple_and_apart(const std::vector<std::vector<Point>>& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    EXPECT_TRUE(is_simple_ring(rings[r])) << "ring " << r;
    for (std::size_t s = r + 1; s < rings.size(); ++s) {
      for (std::size_t i = 0; i < rings[r].size(); ++i) {
        for (std::size_t j = 0; j < rings[s].size(); ++j) {
          const auto& p = rings[r];
          const auto& q = rings[s];
          ASSERT_EQ(meet(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()]).kind,
                    Meeting::kNone)
              << "rings " << r << " and " << s;
        }
      }
    }
  }
}

TEST(Outlines, OneCellIsADiamond) {
  const auto rings = occupied_outlines(drawn({"...", ".#.", "..."}));
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(rings[0].size(), 4U);
  EXPECT_EQ(signed_area_m2(rings[0]), 2.0);  // in quarters of a cell
  EXPECT_EQ(side_of_ring(rings[0], {2.0, 2.0}), PointSide::kInside);
}

TEST(Outlines, WhatCellsEncloseIsAClockwiseRing) {
  const auto rings = occupied_outlines(drawn({"####", "#.?#", "####"}));
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_GT(signed_area_m2(rings[0]), 0.0);
  EXPECT_LT(signed_area_m2(rings[1]), 0.0);
}

TEST(Outlines, CellsThatTouchAtACornerAreJoined) {
  EXPECT_EQ(occupied_outlines(drawn({"#.", ".#"})).size(), 1U);
  EXPECT_EQ(occupied_outlines(drawn({".#", "#."})).size(), 1U);
}

TEST(Outlines, NothingOccupiedHasNone) {
  EXPECT_TRUE(occupied_outlines(drawn({"..", "??"})).empty());
}

TEST(Outlines, OfRandomGridsAreSimpleAndHoldTheOccupiedCentres) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto grid = random_grid(seed, 12, 0.1 * static_cast<double>(seed));
    const auto rings = occupied_outlines(grid);
    expect_simple_and_apart(rings);
    for (std::size_t row = 0; row < grid.rows; ++row) {
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const Point centre{2.0 * static_cast<double>(column), 2.0 * static_cast<double>(row)};
        EXPECT_EQ(is_inside(rings, centre), grid.at(column, row) == Cell::kOccupied)
            << seed << ": " << column << ", " << row;
      }
    }
  }
}

TEST(SimplifiedRings, KeepTheBoundAndStayApart) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto rings = occupied_outlines(random_grid(seed, 14, 0.1 * static_cast<double>(seed)));
    for (const double bound : {0.0, 0.8, 3.0}) {
      const auto simple = simplified_rings(rings, bound);
      ASSERT_EQ(simple.size(), rings.size());
      expect_simple_and_apart(simple);
      for (std::size_t r = 0; r < rings.size(); ++r) {
        for (const Point p : rings[r]) {
          double nearest = HUGE_VAL;
          for (std::size_t i = 0; i < simple[r].size(); ++i) {
            const Point a = simple[r][i], b = simple[r][(i + 1) % simple[r].size()];
            nearest = std::min(nearest, distance(p, closest_point_on_segment(p, a, b)));
          }
          EXPECT_LE(nearest, bound + 1e-12);
        }
      }
    }
  }
}

TEST(SimplifiedRings, AStraightWallKeepsItsEnds) {
  const auto rings = occupied_outlines(drawn({"........", ".######.", ".######.", "........"}));
  EXPECT_EQ(simplified_rings(rings, 0.0)[0].size(), 8U);  // four sides and four chamfers
  EXPECT_EQ(simplified_rings(rings, 1.0)[0].size(), 4U);
}

TEST(SimplifiedRings, ASliverKeepsItsWidth) {
  const auto rings = occupied_outlines(drawn({"........", ".######.", "........"}));
  for (const double bound : {1.0, 50.0}) {
    EXPECT_GE(simplified_rings(rings, bound)[0].size(), 3U);
  }
}

TEST(LinesToMap, EachLineBecomesAWall) {
  const std::vector<Line> lines{{{1.0, 2.0}, {3.0, 2.5}}, {{1.0, 1.0}, {1.0, 1.0}}};
  ImportOptions options;
  options.height_m = 2.5;
  const Map map = lines_to_map(lines, options);
  ASSERT_EQ(map.obstacles.size(), 1U);
  const Segment& wall = map.obstacles[0].segments[0];
  EXPECT_EQ(wall.a, (Point{1.0, 2.0}));
  EXPECT_EQ(wall.b, (Point{3.0, 2.5}));
  EXPECT_EQ(wall.height_m, 2.5);
  EXPECT_EQ(map.obstacles[0].shape_type, ShapeType::kOpenPolygon);
  EXPECT_EQ(map.border, (Border{0.0, 4.0, 4.0, 1.0}));
}

TEST(GridToMap, PlacesCellsByTheOrigin) {
  OccupancyGrid grid = drawn({"...", ".#.", "..."});
  grid.resolution_m = 0.5;
  grid.origin = {10.0, 20.0, Angle::from_degrees(90.0)};
  ImportOptions options;
  options.simplification_m = 0.0;
  const Map map = grid_to_map(grid, options);
  ASSERT_EQ(map.obstacles.size(), 1U);
  // The cell's centre is (0.75, 0.75) from the corner; turned by 90°, (−0.75, 0.75).
  const Box box = extent(map);
  EXPECT_NEAR(box.min_x, 9.0, 1e-9);
  EXPECT_NEAR(box.max_x, 9.5, 1e-9);
  EXPECT_NEAR(box.min_y, 20.5, 1e-9);
  EXPECT_NEAR(box.max_y, 21.0, 1e-9);
}

TEST(GridToMap, TiesInnerRingsToWhatIsAroundThem) {
  const Map map = grid_to_map(drawn({"######", "#....#", "#.##.#", "#.##.#", "#....#", "######"}),
                              {.simplification_m = 0.0});
  ASSERT_EQ(map.obstacles.size(), 3U);
  std::size_t inner = 0;
  for (const auto& obstacle : map.obstacles) {
    if (const auto outer = obstacle.semantic.value(semantic_key::kInnerOf)) {
      ++inner;
      EXPECT_EQ(*outer, std::to_string(map.obstacles[0].id));
    }
  }
  EXPECT_EQ(inner, 1U);
}

TEST(GridToMap, LeavesSmallThingsOut) {
  ImportOptions options;
  options.simplification_m = 0.0;
  options.smallest_area_m2 = 1.0;
  const Map map = grid_to_map(drawn({"......", ".#..##", "....##", "......"}), options);
  EXPECT_EQ(map.obstacles.size(), 1U);
}

TEST(GridDescription, ReadsWhatAMapServerReads) {
  const auto grid = parse_grid_description(
      "image: floor.pgm\nresolution: 0.05\norigin: [-1, 2.5, 0.5]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n",
      "floor.yaml");
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(grid->image, "floor.pgm");
  EXPECT_EQ(grid->origin, (Pose{-1.0, 2.5, Angle::from_radians(0.5)}));
  EXPECT_EQ(grid->cell_of(0.0), Cell::kOccupied);
  EXPECT_EQ(grid->cell_of(205.0), Cell::kUnknown);
  EXPECT_EQ(grid->cell_of(254.0), Cell::kFree);
}

TEST(GridDescription, NegatedAndRawPixels) {
  GridDescription grid;
  grid.negate = true;
  EXPECT_EQ(grid.cell_of(255.0), Cell::kOccupied);
  EXPECT_EQ(grid.cell_of(0.0), Cell::kFree);
  grid.raw = true;
  EXPECT_EQ(grid.cell_of(100.0), Cell::kOccupied);
  EXPECT_EQ(grid.cell_of(0.0), Cell::kFree);
  EXPECT_EQ(grid.cell_of(255.0), Cell::kUnknown);
}

TEST(GridDescription, NamesThePlaceOfAMistake) {
  const auto message = [](const std::string& yaml) {
    const auto grid = parse_grid_description(yaml, "floor.yaml");
    return grid ? std::string("no failure") : grid.error().message;
  };
  EXPECT_NE(message("image: a.pgm\nresolution: fine\n").find("floor.yaml:2:13: error: "),
            std::string::npos);
  EXPECT_NE(message("image: a.pgm\nresolution: 0\n").find("above 0"), std::string::npos);
  EXPECT_NE(message("resolution: 1\n").find("is this a grid map?"), std::string::npos);
  EXPECT_NE(message("image: a\nresolution: 1\norigin: [1, 2]\n").find("floor.yaml:3:"),
            std::string::npos);
  EXPECT_NE(message("image: a\nresolution: 1\nmode: odd\n").find("trinary"), std::string::npos);
}

}  // namespace
}  // namespace mapwright::converter
