// Chains, on a grid and off it, against the obstacles they stand for.
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "mapcore/random.hpp"
#include "mapcore/text/decimal_format.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright {
namespace {

// All lengths of numbers, and the ends of what there are.
std::vector<GridPoint> random_grid_points(std::size_t count, std::int32_t step, Random& random) {
  std::vector<GridPoint> points(count);
  const auto number = [&]() -> std::int32_t {
    constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
    const std::int32_t value =
        static_cast<std::int32_t>(random.below(std::uint64_t{kMost} >> random.below(31)));
    return (random.below(2) == 0 ? -value : value) / step * step;
  };
  for (auto& point : points) point = {number(), number()};
  return points;
}

Obstacle obstacle_of(const ChainRecord& chain, const std::vector<Point>& points) {
  Obstacle obstacle{chain.id, chain.shape_type, Semantic(chain.semantic), {}};
  const std::size_t count = chain.joined ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    obstacle.segments.push_back({points[i], points[(i + 1) % points.size()], chain.height_m,
                                 chain.in_out, Semantic(chain.segment_semantic)});
  }
  return obstacle;
}

// One writer for all, which remembers things from chain to chain: few heights, and more than it
// can.
void expect_same_text(double resolution, std::int32_t step) {
  Random random(11);
  const text::DecimalFormat format(resolution);
  const std::string long_text(5000, 'x');
  const std::string_view texts[] = {"", "a", " building,name=a ", long_text};
  std::ostringstream on_grid, off_grid, segments;
  const WriteOptions options{resolution};
  MapWriter grid_writer(on_grid, options), point_writer(off_grid, options);
  MapWriter segment_writer(segments, options);
  for (int i = 0; i < 400; ++i) {
    const auto grid =
        random_grid_points(2 + (i % 20 == 0 ? random.below(300) : random.below(8)), step, random);
    std::vector<Point> points;
    for (const auto [x, y] : grid) points.push_back({format.of_units(x), format.of_units(y)});
    ChainRecord chain{.id = i,
                      .semantic = texts[random.below(4)],
                      .points = points,
                      .grid_points = {},
                      .joined = random.below(2) == 0,
                      .height_m = 0.5 * static_cast<double>(random.below(i % 2 == 0 ? 3 : 300)),
                      .in_out = random.below(2) == 0 ? InOut::kIndoor : InOut::kOutdoor,
                      .segment_semantic = texts[random.below(4)]};
    segment_writer.obstacle(obstacle_of(chain, points));
    point_writer.obstacle(chain);
    chain.points = {};
    chain.grid_points = grid;
    grid_writer.obstacle(chain);
  }
  for (auto* writer : {&grid_writer, &point_writer, &segment_writer}) writer->finish();
  EXPECT_TRUE(off_grid.str() == segments.str()) << resolution;
  EXPECT_TRUE(on_grid.str() == segments.str()) << resolution;
}

TEST(MapWriter, WritesChainsAsTheirSegments) {
  expect_same_text(0.001, 1);
  expect_same_text(0.005, 5);
  expect_same_text(0.01, 1);
  expect_same_text(1e-9, 1);
  expect_same_text(1.0, 1);
  expect_same_text(1000.0, 1000);
}

}  // namespace
}  // namespace mapwright
