// Repairs, one by one: before and after.
#include "validators/fix/fix_map.hpp"

#include <gtest/gtest.h>

#include "tests/validators/shapes.hpp"

namespace mapwright::validators {
namespace {

constexpr const char* kBorder = "border;0;10;10;0;#\n";
const std::string kSquare =
    "obstacle;1;1;4;column;#\n2;2;4;2;3;1;wall;#\n4;2;4;4;3;1;wall;#\n4;4;2;4;3;1;wall;#\n"
    "2;4;2;2;3;1;wall;#\n";

FixOptions without_layout() {
  FixOptions options;
  options.layout = false;
  return options;
}

FixOutcome fixed(const std::string& text) {
  return fix_map(text, without_layout());
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

std::string square_with(const std::string& what, const std::string& by) {
  return kBorder + with(kSquare, what, by);
}

const std::string kGood = kBorder + kSquare;

TEST(Fix, LeavesASoundMapAsItIs) {
  const auto outcome = fixed(kGood);
  EXPECT_EQ(outcome.text, kGood);
  EXPECT_TRUE(outcome.done.empty());
}

TEST(Fix, CountsSegments) {
  const auto outcome = fixed(square_with(";1;4;column", ";1; 7 ;column"));
  EXPECT_EQ(outcome.text, square_with(";1;4;column", ";1; 4 ;column"));
  ASSERT_EQ(outcome.done.size(), 1U);
  EXPECT_EQ(outcome.done[0].code, FindingCode::F113);
}

TEST(Fix, JoinsEndsThatNearlyMeet) {
  const auto outcome = fixed(square_with("2;4;2;2;3", "2;4;2;2.004;3"));
  EXPECT_EQ(outcome.text, kGood);
  ASSERT_EQ(outcome.moved.size(), 1U);
  EXPECT_EQ(outcome.moved[0].obstacle, 1);
  EXPECT_NEAR(outcome.moved[0].moved_m, 0.004, 1e-12);
  EXPECT_EQ(fixed(square_with("4;4;2;4;3", "4.006;4.005;2;4;3")).text, kGood);
}

TEST(Fix, LeavesEndsApartThatAreFartherThanSnap) {
  const std::string text = square_with("2;4;2;2;3", "2;4;2;2.02;3");
  EXPECT_EQ(fixed(text).text, text);
  FixOptions wide = without_layout();
  wide.snap_m = 0.05;
  EXPECT_EQ(fix_map(text, wide).text, kGood);
}

TEST(Fix, RemovesSuperfluousSegmentsAndCountsThemOff) {
  EXPECT_EQ(fixed(with(square_with("4;2;4;4;3;1;wall;#\n", "4;2;4;2;3;1;x;#\n4;2;4;4;3;1;wall;#\n"),
                       ";1;4;", ";1;5;"))
                .text,
            kGood);
  EXPECT_EQ(
      fixed(with(square_with("4;2;4;4;3;1;wall;#\n", "4;2;4;4;3;1;wall;#\n4;2;4;4;3;1;wall;#\n"),
                 ";1;4;", ";1;5;"))
          .text,
      kGood);
}

TEST(Fix, TurnsOutlinesRound) {
  const std::string text = std::string(kBorder) +
                           "obstacle;1;1;3;column;#\n2.0;2;4;4;3;1;north;#\n4;4;4;2;5;0;east;#\n"
                           "4;2;2;2.00;3;1;south;#\n";
  const auto outcome = fixed(text);
  EXPECT_EQ(outcome.text, std::string(kBorder) +
                              "obstacle;1;1;3;column;#\n2;2.00;4;2;3;1;south;#\n"
                              "4;2;4;4;5;0;east;#\n4;4;2.0;2;3;1;north;#\n");
  EXPECT_TRUE(outcome.moved.empty());
}

TEST(Fix, ClosesAndTurnsInOneGo) {
  const std::string text = std::string(kBorder) +
                           "obstacle;1;1;3;column;#\n2;2;4;4;3;1;w;#\n4;4;4;2;3;1;w;#\n"
                           "4;2;2;2.005;3;1;w;#\n";
  const auto outcome = fixed(text);
  EXPECT_TRUE(outcome.after.empty());
  EXPECT_EQ(outcome.done.size(), 2U);
}

TEST(Fix, OrdersTheBordersCorners) {
  EXPECT_EQ(fixed("border;10;0;0;10;#\n" + kSquare).text, kGood);
}

TEST(Fix, WidensTheBorderToWhatCrossesIt) {
  const auto outcome = fixed("border;0;3.5;10;0;#\n" + kSquare);
  EXPECT_EQ(outcome.text, "border;0;4;10;0;#\n" + kSquare);
  EXPECT_NEAR(outcome.border_moved_m, 0.5, 1e-12);
  // What lies beyond as a whole may be wrong itself.
  const std::string beyond = "border;20;10;30;0;#\n" + kSquare;
  EXPECT_EQ(fixed(beyond).text, beyond);
}

TEST(Fix, WritesAMissingBorder) {
  EXPECT_EQ(fixed(kSquare).text, "border;\n1;5;\n5;1;\n#\n" + kSquare);
}

TEST(Fix, MovesTheBorderToTheBeginning) {
  EXPECT_EQ(fixed(kSquare + kBorder).text, kGood);
}

TEST(Fix, RemovesARepeatedBorderThatSaysTheSame) {
  EXPECT_EQ(fixed(kBorder + std::string("border;0;10.0;10;0;#\n") + kSquare).text, kGood);
  const std::string other = kBorder + std::string("border;0;11;11;0;#\n") + kSquare;
  EXPECT_EQ(fixed(other).text, other);
}

TEST(Fix, RepairsRecordsThatTheReaderUnderstood) {
  EXPECT_EQ(fixed(square_with("3;1;wall;#", "3;1;wall;")).text,
            square_with("3;1;wall;#", "3;1;wall;#"));
  EXPECT_EQ(fixed(square_with("3;1;wall;#", "3;1;wall#")).text, kGood);
  EXPECT_EQ(fixed(square_with("3;1;wall;#", "3;1;#")).text, square_with("3;1;wall;#", "3;1;;#"));
  EXPECT_EQ(fixed(square_with("3;1;wall;#", "3;1;wall;brick;#")).text,
            square_with("3;1;wall;#", "3;1;wall,brick;#"));
  EXPECT_EQ(fixed(square_with("4;2;4;4;3", "4;2;4;4,0;3")).text,
            square_with("4;2;4;4;3", "4;2;4;4.0;3"));
  EXPECT_EQ(fixed(square_with("obstacle;", "OBSTACLE;")).text, kGood);
}

std::string stairs(const std::vector<std::string>& records) {
  std::string text = kBorder;
  text += "obstacle;1;5;" + std::to_string(records.size()) + ";stairs;#\n";
  for (const auto& record : records) text += record + ";1;step;#\n";
  return text;
}

const std::vector<std::string> kSteps{"1;1;4;1;0.17", "1;1.3;4;1.3;0.34", "1;1.6;4;1.6;0.51",
                                      "4;1.9;1;1.9;0"};

TEST(Fix, PrintsStepsInTheOrderTheyRise) {
  EXPECT_EQ(fixed(stairs({kSteps[1], kSteps[0], kSteps[2], kSteps[3]})).text, stairs(kSteps));
  EXPECT_EQ(fixed(stairs({kSteps[3], kSteps[0], kSteps[1], kSteps[2]})).text, stairs(kSteps));
}

TEST(Fix, PutsHeightsInOrderWhereStepsAreThenEqual) {
  EXPECT_EQ(fixed(stairs({"1;1;4;1;0.34", "1;1.3;4;1.3;0.17", kSteps[2], kSteps[3]})).text,
            stairs(kSteps));
  const std::string typing_error =
      stairs({"1;1;4;1;0.17", "1;1.3;4;1.3;0.04", kSteps[2], kSteps[3]});
  EXPECT_EQ(fixed(typing_error).text, typing_error);
}

TEST(Fix, LaysRecordsOutAnew) {
  const std::string text =
      "\xEF\xBB\xBF border ; 0;10.00; 1e1;-0;#\r\n\r\nobstacle;01;1;4;a b,?x=1 ;#" +
      kSquare.substr(kSquare.find('\n') + 1);
  const auto outcome = fix_map(text);
  EXPECT_EQ(outcome.text.substr(0, 58),
            "border;\n0;10;\n10;0;\n#\nobstacle;\n1;1;4;a b,?x=1;\n#\n2;2;\n4;2");
  EXPECT_EQ(outcome.text, format_map(read_map(text).map));
  EXPECT_EQ(fix_map(outcome.text).text, outcome.text);
}

TEST(Fix, LayoutMovesNoNumber) {
  const std::string text =
      "border;0;10;10;0;#\nobstacle;1;2;1;x;#\n0.1234567890123;1;2;3;1;1;w;#\n";
  EXPECT_EQ(read_map(fix_map(text).text).map, read_map(text).map);
}

TEST(Fix, LeavesTextThatBelongsToNoRecord) {
  const std::string text = kBorder + std::string("\"scribble\" #\n") + kSquare;
  const auto outcome = fix_map(text);
  EXPECT_NE(outcome.text.find("\"scribble\" #"), std::string::npos) << outcome.text;
  EXPECT_EQ(fixed(text).text, text);
}

TEST(Fix, UndoesWhatWouldBringAFinding) {
  // Turning the ramp's outline is right; joining the ends of this bow tie shows its crossing.
  const std::string text = std::string(kBorder) +
                           "obstacle;1;1;4;bow tie;#\n2;2;4;4;3;1;w;#\n4;4;4;2;3;1;w;#\n"
                           "4;2;2;4;3;1;w;#\n2;4;2;2.004;3;1;w;#\n";
  const auto before = validate(read_map(text));
  const auto outcome = fixed(text);
  for (const auto& finding : outcome.after) {
    EXPECT_TRUE(std::any_of(before.begin(), before.end(), [&](const Finding& f) {
      return f.code == finding.code && f.obstacle == finding.obstacle;
    })) << finding.message;
  }
}

TEST(Fix, DoesOnlyWhatIsAskedFor) {
  const std::string text = square_with(";1;4;column", ";1;7;column");
  FixOptions none = without_layout();
  none.codes.clear();
  EXPECT_EQ(fix_map(text, none).text, text);
}

TEST(Fix, TellsObstaclesOfOneIdApart) {
  const std::string beside =
      "obstacle;1;1;3;c;#\n6;6;8;6;3;1;w;#\n8;6;8;8;3;1;w;#\n8;8;6;6.004;3;1;w;#\n";
  EXPECT_EQ(fixed(kGood + beside).text, kGood + with(beside, "6.004", "6"));
}

}  // namespace
}  // namespace mapwright::validators
