// Every finding of family F: one text that has it and nothing else, with its exact place, and one
// that nearly has it and stays silent.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "mapcore/text/reader.hpp"
#include "tests/mapcore/text/samples.hpp"

namespace mapwright {
namespace {

using test::kTriangle;
using test::Report;
using test::with;

struct Case {
  std::string name;
  std::string text;
  std::vector<Report> expected;
  std::string near_miss;
};

const std::string kBorder = "border;-4;58;58;-4;#";
const std::string kHeader = "obstacle;\n1;1;3;column;\n#\n";

std::vector<Case> cases() {
  const auto triangle = [](const std::string& what, const std::string& by) {
    return with(kTriangle, what, by);
  };
  return {
      {"EmptyFile", "", {{"F101", 1, 1}}, kBorder},
      {"BlankFile", "\xEF\xBB\xBF \r\n\t\n", {{"F101", 1, 1}}, "\xEF\xBB\xBF \r\n\t\n" + kBorder},
      {"Binary",
       std::string("\x7F"
                   "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0",
                   16),
       {{"F102", 1, 1}},
       triangle("wall", "wa\x01ll")},
      {"Utf16",
       std::string("\xFF\xFE"
                   "b\0o\0r\0",
                   8),
       {{"F102", 1, 1}},
       kTriangle},
      {"InvalidUtf8",
       triangle("column",
                "Pla\xE7"
                "a"),
       {{"F103", 6, 10}},
       triangle("column",
                "Pla\xC3\xA7"
                "a")},
      {"MissingBorder",
       with(kTriangle, "border;\n-4;58;\n58;-4;\n#\n", "\n "),
       {{"F104", 2, 2}},
       kTriangle},
      {"DuplicateBorder", kTriangle + kBorder, {{"F105", 20, 1}}, triangle("column", "border")},
      {"BorderNotFirst",
       with(kTriangle, "border;\n-4;58;\n58;-4;\n#\n", "") + kBorder,
       {{"F106", 16, 1}},
       "\n\n" + kTriangle},
      {"MissingRecordEnd",
       triangle("wall;\n#", "wall;\n"),
       {{"F107", 10, 10}},
       triangle("wall;\n#", "obstacle;#")},
      {"MissingRecordEndAtEnd",
       kTriangle.substr(0, kTriangle.size() - 2),
       {{"F107", 18, 10}},
       kTriangle.substr(0, kTriangle.size() - 1)},
      {"TooFewFields",
       triangle("1;0;\n5;1;wall;", "5;1;wall;"),
       {{"F108", 8, 1, 1, 1}},
       triangle("wall", "")},
      {"TooManyFields",
       triangle("0;1;\n5;1;door;", "0;1;2;3;\n5;1;door;"),
       {{"F108", 12, 1, 1, 2}},
       triangle("door", "1,0,2,3")},
      {"DecimalComma",
       triangle("5;1;door", "1,5;1;door"),
       {{"F109", 14, 1, 1, 2}},
       triangle("5;1;door", "1.5;1;door")},
      {"EmptyNumber",
       triangle("1;0;\n0;1;", "1; ;\n0;1;"),
       {{"F109", 12, 4, 1, 2}},
       triangle("1;0;\n0;1;", " 1 ; 0 ;\n0;1;")},
      {"Unit",
       triangle("5;1;door", "5 m;1;door"),
       {{"F109", 14, 1, 1, 2}},
       triangle("5;1;door", " +5. ;1;door")},
      {"BorderNumber", triangle("58;-4", "58;x"), {{"F109", 3, 4}}, triangle("58;-4", "58;-.4e+1")},
      {"NotANumber",
       triangle("0;1;\n5", "nan;1;\n5"),
       {{"F110", 13, 1, 1, 2}},
       triangle("0;1;\n5", "1e300;1;\n5")},
      {"Infinity",
       triangle("0;1;\n5", "0;-inf;\n5"),
       {{"F110", 13, 3, 1, 2}},
       triangle("0;1;\n5", "0;-0;\n5")},
      {"FractionalCount",
       triangle("1;1;3", "1;1;3.0"),
       {{"F111", 6, 5, 1}},
       triangle("1;1;3", "+1;1;03")},
      {"NegativeCount",
       triangle("1;1;3", "1;1;-3"),
       {{"F111", 6, 5, 1}},
       triangle("1;1;3", "-1;1;3")},
      {"IdInWords", triangle("1;1;3", "one;1;3"), {{"F111", 6, 1}}, triangle("1;1;3", "0;1;3")},
      {"ShapeType7", triangle("1;1;3", "1;7;3"), {{"F112", 6, 3, 1}}, triangle("1;1;3", "1;6;3")},
      {"ShapeType0", triangle("1;1;3", "1;0;3"), {{"F112", 6, 3, 1}}, triangle("1;1;3", "1; 1;3")},
      {"TooManyDeclared", triangle("1;1;3", "1;1;1000000000"), {{"F113", 6, 5, 1}}, kTriangle},
      {"TooFewDeclared",
       triangle("1;1;3", "1;1;2"),
       {{"F113", 6, 5, 1}},
       kBorder + "obstacle;1;1;0;none;#"},
      {"SegmentsBeforeObstacle", with(kTriangle, kHeader, ""), {{"F114", 5, 1}}, kTriangle},
      {"InOut2",
       triangle("5;1;door", "5;2;door"),
       {{"F115", 14, 3, 1, 2}},
       triangle("5;1;door", "5; 0 ;door")},
      {"CutWithinSegment",
       kTriangle + "3;4;5",
       {{"F113", 6, 5, 1}, {"F116", 20, 1, 1, 4}},
       kTriangle + "\n\n"},
      {"CutWithinHeader", kTriangle + "obstacle;2;1", {{"F116", 20, 1}}, kTriangle},
      {"StrayText", kTriangle + "the end", {{"F117", 20, 1}}, kTriangle + "\t"},
      {"StrayRecord", triangle("#\n1;0", "#\nnote to self\n#\n1;0"), {{"F117", 12, 1}}, kTriangle},
      {"StrayBeforeNumber",
       triangle("#\n1;0", "# \" 1;0"),
       {{"F117", 11, 3}},
       triangle("door", "\"")},
      {"StrayBehindLastField",
       triangle("door;\n#", "door;\n- #"),
       {{"F117", 15, 1}},
       triangle("door;\n#", "door;\n\n #")},
      {"CoordinateTooLarge",
       triangle("0;1;\n5", "1e400;1;\n5"),
       {{"F118", 13, 1, 1, 2}},
       triangle("0;1;\n5", "1e-400;1;\n5")},
      {"IdTooLarge",
       triangle("1;1;3", "9223372036854775808;1;3"),
       {{"F118", 6, 1}},
       triangle("1;1;3", "9223372036854775807;1;3")},
      {"EmptyRecord", triangle("#\n1;0", "#\n #\n1;0"), {{"F119", 12, 2}}, kTriangle},
      {"SemanticNotClosed",
       triangle("door;\n#", "door\n#"),
       {{"F120", 14, 9}},
       triangle("door;\n#", "door\n;#")},
      {"KeywordNotClosed",
       triangle("obstacle;\n", "obstacle "),
       {{"F120", 5, 9}},
       triangle("obstacle;\n", "obstacle ; ")},
      {"KeywordInCapitals",
       triangle("obstacle", "Obstacle"),
       {{"F121", 5, 1}},
       triangle("column", "Obstacle")},
      {"MisspeltKeyword",
       triangle("border", "boarder"),
       {{"F121", 1, 1}},
       triangle("column", "boarder")},
      {"LineBreakInSemantic",
       triangle("door", "door\r\nwood"),
       {{"F122", 14, 5, 1, 2}},
       triangle("door", "\ndoor\r\n")},
  };
}

class FormatFindings : public testing::TestWithParam<Case> {};

TEST_P(FormatFindings, ExactlyThese) {
  EXPECT_EQ(test::reports(read_map(GetParam().text).findings), GetParam().expected);
}

TEST_P(FormatFindings, NotTheNearMiss) {
  EXPECT_EQ(test::reports(read_map(GetParam().near_miss).findings), std::vector<Report>{});
}

INSTANTIATE_TEST_SUITE_P(Text, FormatFindings, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name; });

TEST(FormatFindingsList, LeavesNoCodeOut) {
  std::set<std::string> tested;
  for (const auto& one : cases()) {
    for (const auto& report : one.expected) tested.insert(report.code);
  }
  for (const auto& type : finding_catalogue()) {
    if (type.id[0] != 'F') continue;
    EXPECT_TRUE(tested.contains(std::string(type.id))) << type.id;
  }
}

std::string message_of(const std::string& text) {
  const auto findings = read_map(text).findings;
  EXPECT_EQ(findings.size(), 1U);
  return findings.empty() ? "" : findings[0].message;
}

TEST(FormatMessages, SayWhatToWrite) {
  const auto height = [](const std::string& written) {
    return message_of(with(kTriangle, "5;1;door", written + ";1;door"));
  };
  const std::string subject = "segment 2 of obstacle 1: h ";
  EXPECT_EQ(height("1,5"), subject + "'1,5' has a decimal comma; write 1.5");
  EXPECT_EQ(height("5 m"),
            subject + "'5 m' is more than a number; write 5 (all lengths are metres)");
  EXPECT_EQ(height("5m"), subject + "'5m' is more than a number; write 5 (all lengths are metres)");
  EXPECT_EQ(height("1 2"), subject + "'1 2' are two numbers; put a ';' between them");
  EXPECT_EQ(height("\xE2\x88\x92"
                   "5"),
            subject +
                "'\xE2\x88\x92"
                "5' has the character U+2212 for its minus sign; write -5");
  EXPECT_EQ(height("high"), subject + "'high' is not a number");
  EXPECT_EQ(height("0x10"), subject + "'0x10' is not a number");
  EXPECT_EQ(height("\x1B[1m"), subject + "'\\x1B[1m' is not a number");
  EXPECT_EQ(height(""), subject + "is empty; write a number");
  EXPECT_EQ(height("nan"), subject + "is 'nan'; write a finite number");
  EXPECT_EQ(height("1e400"), subject + "'1e400' is too large to hold");
}

TEST(FormatMessages, NameBothCounts) {
  EXPECT_EQ(message_of(with(kTriangle, "1;1;3", "1;1;1000000000")),
            "obstacle 1: declares 1000000000 segments but 3 follow");
  EXPECT_EQ(message_of(with(kTriangle, "1;0;\n5;1;wall;", "5;1;wall;")),
            "segment 1 of obstacle 1: the record has 5 fields instead of 7 "
            "(ax;ay;bx;by;h;inOut;semantic;); left out");
}

}  // namespace
}  // namespace mapwright
