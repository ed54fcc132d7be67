// What is proven to be sound spares the checks a look and changes nothing else: with and without
// proofs, validation finds the same, byte for byte.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/support/random_map.hpp"
#include "tests/validators/mutators.hpp"
#include "tests/validators/shapes.hpp"
#include "validators/survey/survey.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {
namespace {

::testing::AssertionResult finds_the_same(const MapDocument& document,
                                          const ValidationOptions& options = {}) {
  const auto with = validate(document, options, Proofs::kAll);
  const auto without = validate(document, options, Proofs::kNone);
  if (with == without) return ::testing::AssertionSuccess();
  std::string codes;
  for (const auto* findings : {&with, &without}) {
    codes += findings == &with ? "with proofs:" : "; without:";
    for (const auto& finding : *findings) codes += " " + std::string(finding_type(finding.code).id);
  }
  return ::testing::AssertionFailure() << codes << "\n" << document.text.view();
}

::testing::AssertionResult finds_the_same(const Map& map) {
  return finds_the_same(read_map(format_map(map)));
}

TEST(Proofs, ChangeNothingOnMutants) {
  for (const auto& mutator : test::mutators()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Random random(seed, static_cast<std::uint64_t>(mutator.code));
      Map map = test::clean_map(seed);
      if (!mutator.mutate(map, random)) continue;
      ASSERT_TRUE(finds_the_same(map)) << finding_type(mutator.code).id << ", seed " << seed;
    }
  }
}

TEST(Proofs, ChangeNothingOnAnyMap) {
  Random random(95);
  for (int i = 0; i < 1500; ++i) {
    ASSERT_TRUE(finds_the_same(test::random_map(random, {12, 7}))) << "map " << i;
  }
}

// Points of a coarse grid: touching, overlapping, collinear, thin and repeated as often as not.
class CrampedSite {
 public:
  explicit CrampedSite(Random& random) : random_(random) {}

  Map map() {
    Map map{{-1.0, 13.0, 13.0, -1.0}, {}};
    const auto obstacles = 1 + random_.below(6);
    for (std::int64_t id = 1; id <= static_cast<std::int64_t>(obstacles); ++id) {
      map.obstacles.push_back(obstacle(random_.below(20) == 0 ? 1 : id));
    }
    return map;
  }

 private:
  double coordinate() {
    const double on_grid = static_cast<double>(random_.below(13));
    switch (random_.below(8)) {
      case 0:
        return on_grid + 0.001 * static_cast<double>(random_.below(20));
      case 1:
        return on_grid / 8.0;
      default:
        return on_grid;
    }
  }

  Obstacle obstacle(std::int64_t id) {
    const auto type = static_cast<ShapeType>(1 + random_.below(6));
    Obstacle obstacle{id, type, semantic(), {}};
    const std::size_t count = random_.below(7) + (is_closed(type) ? 2 : 0);
    Point from{coordinate(), coordinate()};
    const Point first = from;
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_last = k + 1 == count;
      const Point to = is_last && is_closed(type) && random_.below(10) > 0
                           ? first
                           : Point{coordinate(), coordinate()};
      obstacle.segments.push_back({from, to, height(type, k, is_last), side(), "wall"});
      from = random_.below(12) == 0 ? Point{coordinate(), coordinate()} : to;
    }
    return obstacle;
  }

  std::string semantic() {
    static const std::vector<std::string> kTexts{"building",
                                                 "bench,name=A",
                                                 "bench,name=A",
                                                 "wall,inner_of=1",
                                                 "ramp,normal=0:0.1:0.995",
                                                 "name=B,name=B",
                                                 "bilding",
                                                 "",
                                                 "step,level=2",
                                                 "a\xC2\x80"};
    return kTexts[random_.below(kTexts.size())];
  }

  double height(ShapeType type, std::size_t k, bool is_last) {
    if (random_.below(15) == 0) return 60.0 * random_.uniform(-0.2, 20.0);
    if (type == ShapeType::kRamp || (type == ShapeType::kStairs && is_last)) return 0.0;
    if (type == ShapeType::kStairs) return 0.16 * static_cast<double>(k + 1);
    return random_.below(4) == 0 ? 0.3 : 3.0;
  }

  InOut side() { return random_.below(12) == 0 ? InOut::kIndoor : InOut::kOutdoor; }

  Random& random_;
};

TEST(Proofs, ChangeNothingWhereObstaclesCrowd) {
  Random random(96);
  CrampedSite site(random);
  for (int i = 0; i < 4000; ++i) ASSERT_TRUE(finds_the_same(site.map())) << "map " << i;
}

TEST(Proofs, ChangeNothingWithOtherLimits) {
  ValidationOptions options;
  options.near_miss_m = 0.5;
  options.overlap_depth_m = 0.05;
  options.sliver_width_m = options.spike_width_m = 0.4;
  options.max_step_turn_deg = 1.0;
  options.max_step_tread_m = 0.3;
  options.max_rise_variation_m = 0.0;
  options.laser_height_m = 2.0;
  options.suspect_height_m = 1.0;
  options.min_border_margin_m = 40.0;
  Random random(97);
  CrampedSite site(random);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(finds_the_same(read_map(format_map(site.map())), options)) << "map " << i;
  }
}

// Stairs that are nearly in order: the proof must not take a slip for a plain flight.
TEST(Proofs, ChangeNothingOnFlights) {
  Random random(98);
  for (int i = 0; i < 1500; ++i) {
    Obstacle stairs{1, ShapeType::kStairs, "stairs", {}};
    const auto steps = static_cast<int>(1 + random.below(6));
    const double slip = random.below(3) == 0 ? 0.0 : 0.3;
    for (int k = 0; k <= steps; ++k) {
      const double y = 0.3 * k + slip * random.uniform(-0.5, 0.5);
      const double rise = 0.16 * (k + 1) + slip * random.uniform(-0.3, 0.3);
      Segment step{{0.0, y + slip * random.uniform(-0.3, 0.3)}, {2.0, y}, rise, {}, "step"};
      if (random.below(8) == 0) step.b.x *= random.uniform(0.1, 2.5);
      if (k == steps) {
        step.height_m = 0.0;
        std::swap(step.a, step.b);
      }
      if (random.below(20) == 0) std::swap(step.a, step.b);
      stairs.segments.push_back(step);
    }
    ASSERT_TRUE(finds_the_same(Map{{-50.0, 50.0, 50.0, -50.0}, {stairs}})) << "flight " << i;
  }
}

Map map_of(std::vector<Obstacle> obstacles) {
  return {{-50.0, 50.0, 50.0, -50.0}, std::move(obstacles)};
}

std::size_t chains_in_doubt(const Map& map) {
  const ValidationOptions options;
  return Survey(map, options, Proofs::kAll).in_doubt(Doubt::kChain).size();
}

test::Points circle(int corners, double radius_m) {
  test::Points points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / corners;
    points.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle)});
  }
  return points;
}

TEST(Survey, ProvesSoundChains) {
  const test::Points ell{{0, 0}, {9, 0}, {9, 4}, {4, 4}, {4, 8}, {0, 8}};
  EXPECT_EQ(chains_in_doubt(map_of({test::ring(1, ell)})), 0U);
  EXPECT_EQ(chains_in_doubt(map_of({test::ring(1, circle(1000, 10.0))})), 0U);
  EXPECT_EQ(chains_in_doubt(map_of({test::wall(1, {{0, 0}, {5, 1}, {5, 6}, {1, 6}, {1, 3}})})), 0U);
}

TEST(Survey, DoubtsWhatMeetsItself) {
  EXPECT_EQ(chains_in_doubt(map_of({test::ring(1, {{0, 0}, {4, 4}, {4, 0}, {0, 4}})})), 1U);
  EXPECT_EQ(chains_in_doubt(map_of({test::ring(1, test::reversed(circle(8, 3.0)))})), 1U);
  EXPECT_EQ(chains_in_doubt(map_of({test::wall(1, {{0, 0}, {5, 0}, {2, 0}})})), 1U);
  auto twice_round = circle(7, 10.0);
  for (const Point p : circle(7, 9.0)) twice_round.push_back(p);  // all turns left, but two rounds
  EXPECT_EQ(chains_in_doubt(map_of({test::ring(1, twice_round)})), 1U);
}

TEST(Survey, HasNothingToDoubtInACleanCampus) {
  const Map map = read_map(format_map(test::clean_map(1))).map;
  const ValidationOptions options;
  const Survey survey(map, options, Proofs::kAll);
  for (const Doubt doubt : {Doubt::kHeights, Doubt::kZeroLength, Doubt::kWords, Doubt::kCoordinates,
                            Doubt::kSpike, Doubt::kEmpty, Doubt::kRamp}) {
    EXPECT_EQ(survey.in_doubt(doubt).size(), 0U) << static_cast<int>(doubt);
  }
  EXPECT_LT(survey.in_doubt(Doubt::kChain).size(), map.obstacles.size() / 5);
  EXPECT_FALSE(survey.ids_may_repeat());
}

}  // namespace
}  // namespace mapwright::validators
