// Repairs of maps that were broken in every catalogued way, and of noise: never worse, never
// farther than the tolerance, and nothing more to do the second time.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/validators/mutators.hpp"
#include "validators/fix/fix_map.hpp"

namespace mapwright::validators {
namespace {

constexpr std::uint64_t kMutantsEach = 40;
constexpr double kRounding_m = 1e-9;

using Complaints = std::multiset<std::pair<FindingCode, std::optional<std::int64_t>>>;

Complaints complaints(const std::vector<Finding>& findings) {
  Complaints all;
  for (const auto& f : findings) all.insert({f.code, f.obstacle});
  return all;
}

double distance_to_ends(const Obstacle& obstacle, Point p) {
  double nearest = HUGE_VAL;
  for (const auto& s : obstacle.segments) {
    nearest = std::min({nearest, distance(s.a, p), distance(s.b, p)});
  }
  return nearest;
}

// Every end of a repaired obstacle lies near an end that the obstacle had before.
void expect_unmoved(const Map& before, const Map& after, double tolerance_m) {
  ASSERT_EQ(before.obstacles.size(), after.obstacles.size());
  for (std::size_t i = 0; i < before.obstacles.size(); ++i) {
    EXPECT_EQ(before.obstacles[i].id, after.obstacles[i].id);
    EXPECT_EQ(before.obstacles[i].semantic, after.obstacles[i].semantic);
    if (before.obstacles[i].segments == after.obstacles[i].segments) continue;
    for (const auto& s : after.obstacles[i].segments) {
      for (const Point p : {s.a, s.b}) {
        EXPECT_LE(distance_to_ends(before.obstacles[i], p), tolerance_m + kRounding_m);
      }
    }
  }
}

void expect_sound_repair(const std::string& text, const FixOutcome& outcome) {
  const auto before = complaints(outcome.before);
  const auto after = complaints(validate(read_map(outcome.text)));
  EXPECT_EQ(after, complaints(outcome.after));
  EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end())) << text;
  const auto again = fix_map(outcome.text);
  EXPECT_EQ(again.text, outcome.text) << "repairing twice is not the same as once";
  EXPECT_TRUE(again.done.empty());
}

// Classes in which every mutant becomes the clean map again.
bool is_always_restored(FindingCode code) {
  using enum FindingCode;
  return code == G101 || code == G103 || code == G107 || code == G111 || code == T101 ||
         code == T103 || code == T106;
}

class FixedMutants : public testing::TestWithParam<test::Mutator> {};

TEST_P(FixedMutants, AreNeverWorseAndRestoredWhereThatIsSafe) {
  const auto& mutator = GetParam();
  std::uint64_t made = 0;
  for (std::uint64_t seed = 1; made < kMutantsEach; ++seed) {
    Random random(seed, static_cast<std::uint64_t>(mutator.code));
    const Map clean = test::clean_map(seed % 7 + 1);
    Map map = clean;
    if (!mutator.mutate(map, random)) continue;
    ++made;
    const std::string text = format_map(map);
    const auto outcome = fix_map(text);
    expect_sound_repair(text, outcome);
    expect_unmoved(read_map(text).map, read_map(outcome.text).map, tolerance::kSnap_m);
    if (is_always_restored(mutator.code)) {
      EXPECT_EQ(outcome.text, format_map(clean)) << "seed " << seed;
    }
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, FixedMutants, testing::ValuesIn(test::mutators()),
                         [](const auto& test) {
                           return std::string(finding_type(test.param.code).id);
                         });

// Gaps of chains within the tolerance are closed to the bit.
TEST(FixedGaps, WithinTheToleranceAreRestored) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Map clean = test::clean_map(seed % 7 + 1);
    Map map = clean;
    auto& segments = map.obstacles[random.below(map.obstacles.size())].segments;
    if (segments.back().b != segments.front().a) continue;
    segments.back().b = segments.back().b + Point{random.uniform(0.001, 0.009), 0.0};
    segments[1].a = segments[1].a + Point{0.0, random.uniform(0.001, 0.009)};
    const auto outcome = fix_map(format_map(map));
    EXPECT_EQ(outcome.text, format_map(clean)) << "seed " << seed;
    EXPECT_EQ(outcome.moved.size(), 1U);
  }
}

// Slips of a hand: characters lost, doubled, changed.
std::string scribbled(std::string text, Random& random) {
  static constexpr std::string_view kCharacters = ";#\n.,-0159ab \r\"";
  for (std::uint64_t slips = 1 + random.below(4); slips > 0 && !text.empty(); --slips) {
    const std::size_t at = random.below(text.size());
    const char c = kCharacters[random.below(kCharacters.size())];
    switch (random.below(3)) {
      case 0:
        text.erase(at, 1 + random.below(6));
        break;
      case 1:
        text.insert(at, 1, c);
        break;
      default:
        text[at] = c;
    }
  }
  return text;
}

TEST(FixedNoise, IsNeverWorse) {
  Map map = test::clean_map(3);
  map.obstacles.erase(map.obstacles.begin(), map.obstacles.end() - 16);
  const std::string clean = format_map(map);
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    Random random(seed, 9);
    const std::string text = scribbled(clean, random);
    expect_sound_repair(text, fix_map(text));
    ASSERT_FALSE(HasFailure()) << "seed " << seed << "\n" << text;
  }
}

TEST(FixedNoise, OfRandomBytesHasAnEnd) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed, 10);
    std::string text;
    for (std::uint64_t size = random.below(400); size > 0; --size) {
      static constexpr std::string_view kLikely = ";;;##\n0123456789.-obstacleborder";
      text += random.below(8) == 0 ? static_cast<char>(random.below(256))
                                   : kLikely[random.below(kLikely.size())];
    }
    expect_sound_repair(text, fix_map(text));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mapwright::validators
