#include "validators/fingerprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/validators/shapes.hpp"

namespace mapwright::validators {
namespace {

using test::solid;
using test::wall;

std::vector<Fingerprint> names_of(const std::string& text) {
  const MapDocument document = read_map(text);
  return fingerprints(document, validate(document));
}

std::string text_of(std::vector<Obstacle> obstacles) {
  return format_map(Map{{-50.0, 50.0, 50.0, -50.0}, std::move(obstacles)});
}

std::set<std::string> places_of(const std::string& text) {
  std::set<std::string> places;
  for (const auto& name : names_of(text)) places.insert(name.place);
  return places;
}

// A wall whose second segment does not join, and an obstacle that reaches beyond the border.
std::vector<Obstacle> two_defects(std::int64_t first_id, Point by = {}) {
  Obstacle broken = wall(first_id, {{0, 0}, {1, 0}, {2, 0}});
  broken.segments[1].a = {1.5, 0.5};
  for (auto& s : broken.segments) {
    s.a = s.a + by;
    s.b = s.b + by;
  }
  return {broken, solid(first_id + 1, {48, 0, 52, 2})};
}

// FNV-1a of "G106 at 1500 500" and of "G106 obstacle 1 segment 2": baselines outlive a release.
TEST(Fingerprints, AreWhatTheyWere) {
  const auto names = names_of(text_of(two_defects(1)));
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[0], (Fingerprint{"9fb251b89385f245", "f6027e7d74f9befc"}));
}

TEST(Fingerprints, OfPlacesSurviveRenumberingAndReordering) {
  auto obstacles = two_defects(1);
  const auto places = places_of(text_of(obstacles));
  EXPECT_EQ(places.size(), 2U);
  EXPECT_EQ(places_of(text_of(two_defects(70))), places);
  std::reverse(obstacles.begin(), obstacles.end());
  EXPECT_EQ(places_of(text_of(obstacles)), places);
}

TEST(Fingerprints, SurviveMovedLinesAndAnotherLayout) {
  const std::string text = text_of(two_defects(1));
  std::string one_line = text;
  std::erase(one_line, '\n');
  EXPECT_EQ(names_of("\n\n" + text), names_of(text));
  EXPECT_EQ(names_of(one_line), names_of(text));
}

TEST(Fingerprints, OfSubjectsSurviveMovedObstacles) {
  const auto here = names_of(text_of(two_defects(1)));
  const auto there = names_of(text_of(two_defects(1, {0.5, 0.25})));
  EXPECT_EQ(here[0].subject, there[0].subject);
  EXPECT_NE(here[0].place, there[0].place);
}

TEST(Fingerprints, OfTextSurviveMovedLines) {
  const std::string text =
      "border;0;10;10;0;#\nobstacle;1;2;2;a;#\n1;1;2;x;1;1;w;#\n2;1;3;y;1;1;w;#\n";
  const auto names = names_of(text);
  ASSERT_EQ(names.size(), 2U);
  EXPECT_NE(names[0], names[1]);
  EXPECT_EQ(names_of("\n" + text), names);
}

TEST(Fingerprints, DifferWithinAMap) {
  const auto names =
      names_of("border;0;10;10;0;#\nobstacle;1;2;2;a;#\n1;1;2;x;1;1;w;#\n1;1;2;x;1;1;w;#\n");
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[1].place, names[0].place + "-2");
}

}  // namespace
}  // namespace mapwright::validators
