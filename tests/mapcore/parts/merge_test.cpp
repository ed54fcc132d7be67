// Parts of maps together again.
#include "mapcore/parts/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mapcore/parts/crop.hpp"
#include "mapcore/text/reader.hpp"
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

enum class Cut { kNone, kAll, kSome };

// Parts by a random grid over the border, in random order.
std::vector<MergePart> tiles(const Map& map, Random& random, Cut cut = Cut::kNone) {
  std::vector<MergePart> parts;
  const Box all = map.border.box();
  const auto xs = cuts(random, all.min_x, all.max_x), ys = cuts(random, all.min_y, all.max_y);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      const bool is_cut = cut == Cut::kAll || (cut == Cut::kSome && random.below(2) == 0);
      auto part =
          crop(map, {{xs[i], ys[j], xs[i + 1], ys[j + 1]}, std::nullopt, 0.0}, {is_cut, 0.001});
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

Map site_of(Random& random) {
  test::RandomSiteOptions options;
  options.sound = true;
  return test::random_site(random, options);
}

// What a robot gets is a file.
void send(std::vector<MergePart>& parts) {
  for (auto& part : parts) part.map = read_map(format_map(part.map)).map;
}

TEST(Merge, CutPartsOfAMapAreTheMap) {
  std::size_t pieces = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Map map = site_of(random);
    auto parts = tiles(map, random, seed % 4 == 0 ? Cut::kSome : Cut::kAll);
    send(parts);
    for (const auto& part : parts) {
      for (const auto& o : part.map.obstacles) pieces += o.semantic.value("cut") ? 1 : 0;
    }
    const auto merged = merge(std::move(parts));
    ASSERT_TRUE(merged) << seed << " " << merged.error().message;
    EXPECT_EQ(format_map(merged->map), format_map(map)) << seed;
    EXPECT_TRUE(merged->notes.empty()) << seed;
  }
  EXPECT_GT(pieces, 400U);
}

TEST(Merge, InSeveralStepsAndTwiceIsTheSame) {
  for (std::uint64_t seed = 300; seed < 350; ++seed) {
    Random random(seed);
    const Map map = site_of(random);
    auto parts = tiles(map, random, Cut::kSome);
    send(parts);
    std::vector<MergePart> halves{{"even", {}}, {"odd", {}}};
    for (std::size_t half = 0; half < 2; ++half) {
      std::vector<MergePart> own;
      for (std::size_t i = half; i < parts.size(); i += 2) own.push_back(parts[i]);
      if (own.empty()) own.push_back(parts[0]);
      own.push_back(own.front());
      halves[half].map = merge(own)->map;
    }
    const auto merged = merge(halves);
    ASSERT_TRUE(merged) << seed;
    EXPECT_EQ(format_map(merged->map), format_map(map)) << seed;
    EXPECT_EQ(format_map(merge({{"", merged->map}})->map), format_map(map)) << seed;
  }
}

TEST(Merge, OverlappingCutPartsAreTheMap) {
  for (std::uint64_t seed = 400; seed < 450; ++seed) {
    Random random(seed);
    const Map map = site_of(random);
    const Box all = map.border.box();
    const double a = std::round(random.uniform(-150, 0)), b = std::round(random.uniform(0, 150));
    std::vector<MergePart> parts;
    for (const Box& box :
         {Box{all.min_x, all.min_y, b, all.max_y}, Box{a, all.min_y, all.max_x, all.max_y},
          Box{all.min_x, a, all.max_x, b}}) {
      parts.push_back({"", crop(map, {box, std::nullopt, 0.0}, {true, 0.001})->map});
    }
    const auto merged = merge(std::move(parts));
    ASSERT_TRUE(merged) << seed << " " << merged.error().message;
    EXPECT_EQ(format_map(merged->map), format_map(map)) << seed;
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

// A wall from (0, 0) to (10, 0), cut at x = 4.
std::vector<MergePart> two_halves_of_a_wall() {
  Map map{{0, 5, 10, -5}, {}};
  Obstacle fence;
  fence.id = 3;
  fence.shape_type = ShapeType::kOpenPolygon;
  fence.semantic = "fence,name=a;b%2C/:=";
  fence.segments = {{{0, 0}, {10, 0.007}, 2.0, InOut::kIndoor, "wood, old"},
                    {{10, 0.007}, {10, 5}, 2.0, InOut::kIndoor, "wood, old"}};
  map.obstacles.push_back(fence);
  std::vector<MergePart> parts;
  for (const Box& box : {Box{0, -5, 4, 5}, Box{4, -5, 10, 5}}) {
    parts.push_back({box.min_x == 0 ? "west" : "east",
                     crop(map, {box, std::nullopt, 0.0}, {true, 0.001})->map});
  }
  return parts;
}

TEST(Merge, TakesPiecesThatWereChangedForNoPieces) {
  auto parts = two_halves_of_a_wall();
  ASSERT_EQ(parts[1].map.obstacles.size(), 1U);
  ASSERT_TRUE(merge(parts));
  const auto is_refused = [](const std::vector<MergePart>& changed) {
    const auto merged = merge(changed);
    return !merged && merged.error().message.find("west: obstacle 3") != std::string::npos;
  };
  auto higher = parts, moved = parts, shrunk = parts, renamed = parts;
  higher[0].map.obstacles[0].segments[0].height_m = 2.5;
  moved[0].map.obstacles[0].segments[0].b.y += 0.001;
  shrunk[0].map.border.right = 3.0;
  renamed[0].map.obstacles[0].id = 4;
  EXPECT_TRUE(is_refused(higher));
  EXPECT_TRUE(is_refused(moved));
  EXPECT_TRUE(is_refused(shrunk));
  EXPECT_FALSE(merge(renamed));
}

TEST(Merge, TakesBackWhatRobotsAdd) {
  auto parts = two_halves_of_a_wall();
  auto found = wall(9, 1);
  parts[0].map.obstacles.push_back(found);
  const auto merged = merge(parts);
  ASSERT_TRUE(merged);
  ASSERT_EQ(merged->map.obstacles.size(), 2U);
  EXPECT_EQ(merged->map.obstacles[1], found);
}

TEST(Merge, RecordsThatAreNoneAreTokensLikeOthers) {
  for (const std::string token : {"cut=7", "cut=", "cut=0.001/1:2", "cut=x/1:2:", "cut=0.001/3:9:",
                                  "cut=0.001/3:2:%4", "cut=0/3:2:"}) {
    const auto merged = merge({part("a", {wall(1, 0, token)})});
    ASSERT_TRUE(merged) << token;
    EXPECT_EQ(merged->map.obstacles[0].semantic, Semantic(token));
  }
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
