// Lists as the kernels read them.
#include "navcore/engine/packed_cell.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace mapwright::navcore::engine {
namespace {

// Segments that are told apart by their numbers.
std::vector<CellWall> segments(std::uint32_t first, std::uint32_t count) {
  std::vector<CellWall> walls;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const double x = i;
    walls.push_back({{x, x + 0.25}, {x + 0.5, x + 0.75}, 1000 + i});
  }
  return walls;
}

void expect_run(const PackedCell& cell, SegmentRun run, std::uint32_t first, std::uint32_t count) {
  ASSERT_EQ(run.first, first);
  ASSERT_EQ(run.count, count);
  const float* const ends = cell.ends(run);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(first + i);
    EXPECT_EQ(ends[i], x);
    EXPECT_EQ(ends[count + i], x + 0.25F);
    EXPECT_EQ(ends[2 * count + i], x + 0.5F);
    EXPECT_EQ(ends[3 * count + i], x + 0.75F);
    EXPECT_EQ(cell.item(first + i), 1000 + first + i);
  }
}

TEST(PackedCell, HoldsRunsOfAnyLength) {
  CellWalls walls;
  walls.two_sided = segments(0, 19);
  walls.one_sided = segments(19, 3);
  walls.stairs.push_back({segments(28, 1), segments(24, 4), segments(22, 2)});
  walls.stairs.push_back({segments(30, 17), {}, segments(29, 1)});
  AlignedFloats memory(packed_size(walls) / sizeof(float) + 1);
  const PackedCell& cell = *pack(walls, reinterpret_cast<std::byte*>(memory.data()));
  EXPECT_EQ(packed_size(cell), packed_size(walls));
  EXPECT_EQ(cell.size, 47U);
  expect_run(cell, cell.two_sided(), 0, 19);
  EXPECT_EQ(cell.first_stop, 19U);
  EXPECT_EQ(cell.first_top, 19U);
  expect_run(cell, cell.one_sided(), 19, 3);
  ASSERT_EQ(cell.stairs().size(), 2U);
  expect_run(cell, cell.stairs()[0].tops, 22, 2);
  expect_run(cell, cell.stairs()[0].low_steps, 24, 4);
  expect_run(cell, cell.stairs()[0].stops, 28, 1);
  expect_run(cell, cell.stairs()[1].tops, 29, 1);
  expect_run(cell, cell.stairs()[1].stops, 30, 17);
}

TEST(PackedCell, ALoneStaircaseStandsWithTheWalls) {
  CellWalls walls;
  walls.two_sided = segments(0, 5);
  walls.stairs.push_back({segments(5, 3), {}, segments(8, 2)});
  walls.one_sided = segments(10, 1);
  AlignedFloats memory(packed_size(walls) / sizeof(float) + 1);
  const PackedCell& cell = *pack(walls, reinterpret_cast<std::byte*>(memory.data()));
  EXPECT_EQ(packed_size(cell), packed_size(walls));
  expect_run(cell, cell.two_sided(), 0, 10);
  EXPECT_EQ(cell.first_stop, 5U);
  EXPECT_EQ(cell.first_top, 8U);
  expect_run(cell, cell.one_sided(), 10, 1);
  EXPECT_TRUE(cell.stairs().empty());
}

TEST(PackedCell, LowStepsKeepAStaircaseApart) {
  CellWalls walls;
  walls.stairs.push_back({segments(2, 1), segments(1, 1), segments(0, 1)});
  AlignedFloats memory(packed_size(walls) / sizeof(float) + 1);
  const PackedCell& cell = *pack(walls, reinterpret_cast<std::byte*>(memory.data()));
  EXPECT_EQ(cell.two_sided().count, 0U);
  EXPECT_EQ(cell.stairs().size(), 1U);
}

TEST(PackedCell, MayBeEmpty) {
  AlignedFloats memory(packed_size(CellWalls{}) / sizeof(float));
  const PackedCell& cell = *pack({}, reinterpret_cast<std::byte*>(memory.data()));
  EXPECT_EQ(cell.two_sided().count, 0U);
  EXPECT_TRUE(cell.stairs().empty());
}

}  // namespace
}  // namespace mapwright::navcore::engine
