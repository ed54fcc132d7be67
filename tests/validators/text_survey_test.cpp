// A look at a text spares it being read only where reading and validating would find nothing; and
// what it hands on to the checks changes nothing.
#include "validators/survey/text_survey.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/support/random_map.hpp"
#include "tests/support/random_site.hpp"
#include "tests/validators/mutators.hpp"
#include "tests/validators/shapes.hpp"

namespace mapwright::validators {
namespace {

// How often each answer was given.
struct Tally {
  int sound = 0, surveyed = 0, given_up = 0;
};

::testing::AssertionResult agrees(const std::string& text, Tally& tally,
                                  const ValidationOptions& options = {}) {
  const MapDocument document = read_map(text);
  const auto expected = validate(document, options);
  TextSurvey look = survey_text(text, options);
  ++(look.is_sound ? tally.sound : look.survey ? tally.surveyed : tally.given_up);
  if (look.is_sound && !(look.border == document.map.border)) {
    return ::testing::AssertionFailure() << "another border\n" << text;
  }
  const auto found =
      look.is_sound ? std::vector<Finding>() : validate(document, options, std::move(look.survey));
  if (found == expected) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << found.size() << " findings instead of " << expected.size() << "\n"
         << text;
}

TEST(TextSurvey, AgreesOnMutants) {
  Tally tally;
  for (const auto& mutator : test::mutators()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Random random(seed, static_cast<std::uint64_t>(mutator.code));
      Map map = test::clean_map(seed);
      if (!mutator.mutate(map, random)) continue;
      ASSERT_TRUE(agrees(format_map(map), tally)) << finding_type(mutator.code).id;
    }
  }
  EXPECT_EQ(tally.sound, 0);
}

TEST(TextSurvey, AgreesOnAnyMap) {
  Tally tally;
  Random random(113);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(agrees(format_map(test::random_map(random, {8, 7})), tally)) << "map " << i;
  }
  EXPECT_GT(tally.given_up, 500);
}

// A few rings, walls and rooms somewhere: some apart, some on each other, some beyond the border.
Map sparse_site(Random& random) {
  Map map{{-100.0, 100.0, 100.0, -100.0}, {}};
  const auto count = static_cast<std::int64_t>(random.below(7));
  for (std::int64_t id = 1; id <= count; ++id) {
    const Point at{std::round(random.uniform(-95.0, 92.0)),
                   std::round(random.uniform(-95.0, 92.0))};
    const double width = 1.0 + std::round(random.uniform(0.0, 12.0)), height = 1.0 + width / 2.0;
    const Box box{at.x, at.y, at.x + width, at.y + height};
    switch (random.below(6)) {
      case 0:
        map.obstacles.push_back(test::hollow(id, box));
        break;
      case 1:
        map.obstacles.push_back(
            test::wall(id, {at, {at.x + width, at.y}, {at.x + width, at.y + height}}));
        break;
      case 2:  // L-shaped
        map.obstacles.push_back(test::ring(id, {at,
                                                {box.max_x, at.y},
                                                {box.max_x, at.y + height / 2.0},
                                                {at.x + width / 2.0, at.y + height / 2.0},
                                                {at.x + width / 2.0, box.max_y},
                                                {at.x, box.max_y}}));
        break;
      default:
        map.obstacles.push_back(test::solid(id, box));
    }
    static const std::vector<std::string> kTexts{
        "building",        "building,name=A",         "building,name=B",
        "building,name=C", "building,name=D,level=2", "shed, name= E ",
        "shed,source=a:1"};
    map.obstacles.back().semantic = kTexts[random.below(kTexts.size())];
  }
  return map;
}

TEST(TextSurvey, AgreesWhereThereIsRoom) {
  Tally tally;
  Random random(114);
  for (int i = 0; i < 6000; ++i) {
    ASSERT_TRUE(agrees(format_map(sparse_site(random)), tally)) << "map " << i;
  }
  EXPECT_GT(tally.sound, 1000);
  EXPECT_GT(tally.surveyed, 1000);
  EXPECT_GT(tally.given_up, 500);
}

TEST(TextSurvey, AgreesWithOtherLimits) {
  ValidationOptions options;
  options.near_miss_m = 3.0;
  options.max_border_margin_m = 20.0;
  options.min_border_margin_m = 30.0;
  options.sliver_width_m = options.spike_width_m = 0.8;
  Tally tally;
  Random random(115);
  for (int i = 0; i < 2000; ++i) {
    ASSERT_TRUE(agrees(format_map(sparse_site(random)), tally, options)) << "map " << i;
  }
}

TEST(TextSurvey, AgreesOnSites) {
  Tally tally;
  Random random(116);
  for (int i = 0; i < 300; ++i) {
    const bool sound = i % 2 == 0;
    ASSERT_TRUE(agrees(format_map(test::RandomSite(random, {200.0, 0.001, sound}).make()), tally))
        << "map " << i;
  }
}

std::string text_with(const Border& border, std::vector<Obstacle> obstacles) {
  return format_map({border, std::move(obstacles)});
}

const Border kBorder{-10.0, 10.0, 10.0, -10.0};

TEST(TextSurvey, ProvesWhatLiesApartWithinItsBorder) {
  const auto obstacles = [] {
    return std::vector{test::solid(1, {-5, -5, -3, -3}), test::wall(2, {{1, 1}, {4, 1}, {4, 3}})};
  };
  EXPECT_TRUE(survey_text(text_with(kBorder, obstacles())).is_sound);
  EXPECT_TRUE(survey_text(text_with(kBorder, {})).is_sound);
  EXPECT_FALSE(survey_text(text_with({-5.0, 10.0, 10.0, -10.0}, obstacles())).is_sound);  // touches
  EXPECT_FALSE(survey_text(text_with({-4.0, 10.0, 10.0, -10.0}, obstacles())).is_sound);
  EXPECT_FALSE(survey_text(text_with({-500.0, 10.0, 10.0, -10.0}, obstacles())).is_sound);
  EXPECT_FALSE(survey_text(text_with({10.0, 10.0, -10.0, -10.0}, obstacles())).is_sound);
  EXPECT_FALSE(survey_text(text_with({-1e9, 10.0, 10.0, -10.0}, {})).is_sound);  // absurd
}

// More than lie in one bucket; the two that share a name are anywhere.
TEST(TextSurvey, FindsANameThatComesTwiceAmongThousands) {
  constexpr std::size_t kObstacles = 5000;
  Map map{{-2.0, 502.0, 502.0, -2.0}, {}};
  for (std::size_t i = 0; i < kObstacles; ++i) {
    const Point at{5.0 * static_cast<double>(i % 100), 10.0 * static_cast<double>(i / 100)};
    auto box = test::solid(static_cast<std::int64_t>(i + 1), {at.x, at.y, at.x + 2.0, at.y + 2.0});
    box.semantic = Semantic("building,name=house " + std::to_string(i));
    map.obstacles.push_back(std::move(box));
  }
  Tally tally;
  ASSERT_TRUE(agrees(format_map(map), tally));
  EXPECT_EQ(tally.sound, 1);
  Random random(115);
  for (int i = 0; i < 20; ++i) {
    Map other = map;
    const std::size_t p = random.below(kObstacles), q = random.below(kObstacles);
    other.obstacles[p].semantic = map.obstacles[q].semantic;
    ASSERT_TRUE(agrees(format_map(other), tally)) << p << " " << q;
  }
  EXPECT_GE(tally.surveyed, 19);
}

TEST(TextSurvey, KnowsWhetherObstaclesNameTheirSources) {
  auto obstacle = test::solid(1, {-5, -5, -3, -3});
  EXPECT_FALSE(survey_text(text_with(kBorder, {obstacle})).may_name_sources);
  obstacle.semantic = "building,source=buildings:12";
  const auto look = survey_text(text_with(kBorder, {obstacle}));
  EXPECT_TRUE(look.may_name_sources);
  EXPECT_TRUE(look.is_sound);
  EXPECT_TRUE(survey_text("border;#").may_name_sources);  // it cannot tell
}

// The same string again and again, and names that follow it, are known by the one before.
TEST(TextSurvey, JudgesStringsThatRepeatAsItDoesTheFirst) {
  for (const char* odd :
       {"building,name=", "building,name= ", "building,name=A,bilding", "building,name=A,name=B",
        "building,name=\xC2\x80", "building,name=A,level=", "bilding", "building,name=C"}) {
    std::vector<Obstacle> obstacles;
    for (const char* text : {"building,name=C", "building,name=D", odd, "building,name=E"}) {
      const double x = static_cast<double>(obstacles.size()) * 4.0 - 8.0;
      obstacles.push_back(
          test::solid(static_cast<std::int64_t>(obstacles.size()) + 1, {x, -2.0, x + 2.0, 2.0}));
      obstacles.back().semantic = text;
    }
    Tally tally;
    EXPECT_TRUE(agrees(text_with(kBorder, obstacles), tally)) << odd;
    EXPECT_EQ(tally.sound, 0) << odd;
  }
}

TEST(TextSurvey, TellsHowFarTheChecksAre) {
  const MapDocument document = read_map(text_with(kBorder, {test::solid(1, {-5, -5, -3, -3})}));
  std::size_t last = 0, all = 0;
  validate(document, {}, std::nullopt, [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(done, ++last);
    all = total;
  });
  EXPECT_EQ(last, all);
  EXPECT_GT(all, 40U);
}

}  // namespace
}  // namespace mapwright::validators
