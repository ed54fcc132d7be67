// Parts of maps together again.
#include "mapcore/parts/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mapcore/parts/crop.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/support/random_site.hpp"

namespace mapwright {
namespace {

std::vector<double> cuts(Random& random, double from, double to) {
  std::vector<double> places{from, to};
  for (auto i = random.below(5); i > 0; --i) {
    places.push_back(std::round(random.uniform(from, to) * 10.0) / 10.0);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

// Parts by a random grid over the border, in random order.
std::vector<MergePart> tiles(const Map& map, Random& random) {
  std::vector<MergePart> parts;
  const Box all = map.border.box();
  const auto xs = cuts(random, all.min_x, all.max_x), ys = cuts(random, all.min_y, all.max_y);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      auto part = crop(map, {{xs[i], ys[j], xs[i + 1], ys[j + 1]}, std::nullopt, 0.0});
      EXPECT_TRUE(part.has_value());
      parts.push_back({"tile " + std::to_string(parts.size()), std::move(part->map)});
    }
  }
  for (std::size_t i = parts.size(); i > 1; --i) std::swap(parts[i - 1], parts[random.below(i)]);
  return parts;
}

TEST(Merge, PartsOfAMapAreTheMap) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    test::RandomSiteOptions options;
    options.sound = true;
    const Map map = test::random_site(random, options);
    const auto merged = merge(tiles(map, random));
    ASSERT_TRUE(merged) << seed << " " << merged.error().message;
    EXPECT_EQ(format_map(merged->map), format_map(map)) << seed;
    EXPECT_TRUE(merged->notes.empty()) << seed;
  }
}

Obstacle wall(std::int64_t id, double x, const std::string& semantic = "wall") {
  Obstacle obstacle;
  obstacle.id = id;
  obstacle.shape_type = ShapeType::kOpenPolygon;
  obstacle.semantic = semantic;
  obstacle.segments.push_back({{x, 0}, {x + 1, 0}, 2.0, InOut::kOutdoor, "brick"});
  return obstacle;
}

MergePart part(const std::string& name, std::vector<Obstacle> obstacles) {
  return {name, {{0, 9, 9, 0}, std::move(obstacles)}};
}

std::vector<std::int64_t> ids(const Map& map) {
  std::vector<std::int64_t> all;
  for (const auto& obstacle : map.obstacles) all.push_back(obstacle.id);
  return all;
}

TEST(Merge, OrderOfThePartsHoldsWhereItSaysSomething) {
  const auto merged = merge({part("a", {wall(9, 0), wall(2, 2), wall(5, 4)}),
                             part("b", {wall(2, 2), wall(7, 6), wall(5, 4)})});
  ASSERT_TRUE(merged);
  EXPECT_EQ(ids(merged->map), (std::vector<std::int64_t>{9, 2, 7, 5}));
}

TEST(Merge, ContradictingOrdersEndToo) {
  const auto merged =
      merge({part("a", {wall(1, 0), wall(2, 2)}), part("b", {wall(2, 2), wall(1, 0)})});
  ASSERT_TRUE(merged);
  EXPECT_EQ(ids(merged->map), (std::vector<std::int64_t>{1, 2}));
}

TEST(Merge, StrangersOfTheSameIdGetNewOnesAndTheirHolesFollow) {
  const auto merged = merge({part("a", {wall(1, 0), wall(4, 2)}),
                             part("b", {wall(1, 50), wall(2, 52, "court,inner_of=1")})});
  ASSERT_TRUE(merged);
  EXPECT_EQ(ids(merged->map), (std::vector<std::int64_t>{1, 4, 5, 2}));
  EXPECT_EQ(merged->map.obstacles[3].semantic, Semantic("court,inner_of=5"));
  ASSERT_EQ(merged->notes.size(), 1U);
  EXPECT_NE(merged->notes[0].find("b: obstacle 1 becomes 5"), std::string::npos);
}

TEST(Merge, VersionsOfOneObstacleNeedAChoice) {
  const std::vector<MergePart> parts{part("a", {wall(1, 0, "old")}),
                                     part("b", {wall(1, 0, "new")})};
  const auto refused = merge(parts);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("obstacle 1"), std::string::npos);
  EXPECT_EQ(merge(parts, MergePreference::kFirst)->map.obstacles[0].semantic, Semantic("old"));
  const auto last = merge(parts, MergePreference::kLast);
  EXPECT_EQ(last->map.obstacles[0].semantic, Semantic("new"));
  EXPECT_EQ(last->map.obstacles.size(), 1U);
}

TEST(Merge, AnIdUsedTwiceWithinAPartStaysSo) {
  const auto merged = merge({part("a", {wall(1, 0), wall(1, 5)})});
  ASSERT_TRUE(merged);
  EXPECT_EQ(ids(merged->map), (std::vector<std::int64_t>{1, 1}));
}

}  // namespace
}  // namespace mapwright
