// Rules of single checks that their fixtures do not show.
#include <gtest/gtest.h>

#include "tests/validators/shapes.hpp"

namespace mapwright::test {
namespace {

std::string codes_of(const std::string& text) {
  std::string codes;
  for (const auto& f : validators::validate(read_map(text))) {
    codes += std::string(finding_type(f.code).id) + " ";
  }
  return codes;
}

// Obstacle 26 of the report's sample, whole: printed from the top down.
TEST(Stairs, OfTheReportsSampleHaveNoError) {
  const auto findings =
      validators::validate(read_map("border;-4;58;58;-4;#obstacle;26;5;4;step,FIBsquare;#"
                                    "34.65;40.72;57.5;40.72;0;1;wall,grey,cement;#"
                                    "57.5;41.02;34.65;41.02;2;1;wall,grey,cement;#"
                                    "57.5;41.32;34.65;41.32;1.8;1;wall,grey,cement;#"
                                    "57.5;41.62;34.65;41.62;1.6;1;wall,grey,cement;#"));
  EXPECT_FALSE(has_errors(findings));
  ASSERT_EQ(findings.size(), 1U);  // its lowest printed step is 1.6 m high
  EXPECT_EQ(findings.front().code, FindingCode::T104);
  EXPECT_EQ(findings.front().segment, 4U);
}

Obstacle stairs(const std::vector<std::pair<Points, double>>& rows) {
  Obstacle obstacle{1, ShapeType::kStairs, "stairs", {}};
  for (const auto& [ends, height_m] : rows) {
    obstacle.segments.push_back({ends[0], ends[1], height_m, InOut::kOutdoor, "step"});
  }
  return obstacle;
}

TEST(Stairs, OfOneStepCloseInEitherOrder) {
  EXPECT_EQ(found_in({stairs({{{{0, 0}, {3, 0}}, 0.2}, {{{3, 0.3}, {0, 0.3}}, 0.0}})}), "");
  EXPECT_EQ(found_in({stairs({{{{3, 0.3}, {0, 0.3}}, 0.0}, {{{0, 0}, {3, 0}}, 0.2}})}), "");
}

TEST(Stairs, MayCloseOnTheHighestStep) {
  EXPECT_EQ(
      found_in({stairs(
          {{{{0, 0}, {3, 0}}, 0.2}, {{{0, 0.3}, {3, 0.3}}, 0.4}, {{{3, 0.3}, {0, 0.3}}, 0.0}})}),
      "");
}

TEST(Stairs, MayHaveRisersOfSeveralPieces) {
  EXPECT_EQ(found_in({stairs({{{{0, 0}, {3, 0}}, 0.2},
                              {{{3, 0}, {6, 0.2}}, 0.2},
                              {{{6, 0.6}, {0, 0.6}}, 0.0}})}),
            "");
  EXPECT_EQ(found_in({stairs({{{{0, 0}, {3, 0}}, 0.2},
                              {{{0, 0.3}, {3, 0.3}}, 0.2},
                              {{{3, 0.6}, {0, 0.6}}, 0.0}})}),
            "T101:1.2 ");
}

TEST(Stairs, WithoutStepsOrWithSeveralClosingSegments) {
  EXPECT_EQ(found_in({stairs({{{{0, 0}, {3, 0}}, 0.0}})}), "T101:1 ");
  EXPECT_EQ(found_in({stairs({{{{0, 0}, {3, 0}}, 0.2},
                              {{{3, 0.3}, {0, 0.3}}, 0.0},
                              {{{0, 0.6}, {3, 0.6}}, 0.4},
                              {{{3, 0.9}, {0, 0.9}}, 0.0}})}),
            "T101:1.2 ");
}

TEST(Stairs, MayWindAroundACorner) {
  std::vector<std::pair<Points, double>> rows;
  for (int i = 0; i <= 18; ++i) {
    const double angle = i * 9.0 * 3.14159265358979 / 180.0;
    const Point direction{std::cos(angle), std::sin(angle)};
    const bool is_top = i == 18;
    rows.push_back(
        {{is_top ? 4.0 * direction : 1.0 * direction, is_top ? 1.0 * direction : 4.0 * direction},
         is_top ? 0.0 : 0.17 * (i + 1)});
  }
  EXPECT_EQ(found_in({stairs(rows)}), "");
}

TEST(Chains, OfStairsNeedNotJoin) {
  EXPECT_EQ(found_in({wall(1, {{0, 0}, {3, 0}}), wall(2, {{0, 1}, {3, 1}})}), "");
}

TEST(SelfIntersection, OfOpenWallsMayTouchButNotCross) {
  EXPECT_EQ(found_in({wall(1, {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 0}})}), "");
  EXPECT_EQ(found_in({wall(1, {{0, 0}, {4, 0}, {4, 4}, {0, 0}})}), "");
  EXPECT_EQ(found_in({wall(1, {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -1}})}), "G104:1.4 ");
  EXPECT_EQ(found_in({wall(1, {{0, 0}, {4, 0}, {4, 4}, {3, 0}, {1, 0}})}), "G104:1.4 ");
}

TEST(SelfIntersection, OfOutlinesTellsEachPointOnce) {
  EXPECT_EQ(found_in({ring(1, {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})}), "G104:1.3 ");
  EXPECT_EQ(found_in({ring(1, {{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}})}), "G104:1.4 ");
  EXPECT_EQ(found_in({ring(1, {{0, 0}, {6, 0}, {4, 0}, {4, 4}})}), "G104:1.2 G104:1.3 ");
}

TEST(SelfIntersection, OfLargeOutlinesIsFoundAsInSmallOnes) {
  Points points;
  for (int i = 0; i < 400; ++i) points.push_back({0.1 * i, 0.0});
  for (int i = 399; i >= 0; --i) points.push_back({0.1 * i, 5.0});
  EXPECT_EQ(found_in({ring(1, points)}), "");
  points[600].y = -1.0;  // a needle from the upper side through the lower one
  EXPECT_EQ(found_in({ring(1, points)}), "G104:1.600 G104:1.601 ");
}

TEST(Cascades, NeedNoFurtherFindings) {
  // A segment that cannot be read leaves a gap, which is not told of again.
  EXPECT_EQ(
      codes_of("border;0;9;9;0;#obstacle;1;1;3;x;#1;1;5;1;3;1;;#5;1;5;y;3;1;;#5;5;1;1;3;1;;#"),
      "F109 ");
  // Without border nothing lies beyond it.
  EXPECT_EQ(codes_of("obstacle;1;2;1;x;#1;1;5;1;3;1;;#"), "F104 ");
  EXPECT_EQ(codes_of("border;a;9;9;0;#obstacle;1;2;1;x;#1;1;5;1;3;1;;#"), "F109 ");
  // A repeated segment breaks the chain only because it is repeated.
  EXPECT_EQ(codes_of("border;0;9;9;0;#obstacle;1;2;3;x;#"
                     "1;1;5;1;3;1;;#1;1;5;1;3;1;;#5;1;5;5;3;1;;#"),
            "G111 ");
  // A ring that refers to a broken outline.
  EXPECT_EQ(codes_of("border;0;9;9;0;#obstacle;1;1;4;x;#"
                     "1;1;8;1;3;1;;#8;1;8;8;3;1;;#8;8;1;8;3;1;;#1;8;1;1.1;3;1;;#"
                     "obstacle;2;1;4;x,inner_of=1;#"
                     "3;3;3;5;3;1;;#3;5;5;5;3;1;;#5;5;5;3;3;1;;#5;3;3;3;3;1;;#"),
            "G105 ");
}

TEST(Findings, OfReaderAndChecksComeInTheOrderOfTheText) {
  EXPECT_EQ(codes_of("border;0;9;9;0;#\nobstacle;-1;2;1; ;#\n1;1;5;1;-3;7;;#\n"),
            "S102 S103 S106 F115 ");
}

TEST(Semantics, MayBeInAnyLanguage) {
  for (const char* text : {"edifici A5, il·luminació", "Gebäude", "Ångström", "建物", "здание"}) {
    Obstacle obstacle = solid(1, {0, 0, 1, 1});
    obstacle.semantic = text;
    EXPECT_EQ(found_in({obstacle}), "") << text;
  }
}

}  // namespace
}  // namespace mapwright::test
