// A finding's fix is a promise: afterwards the finding is gone, and nothing else has come.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "mapcore/text/edits.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/support/data.hpp"
#include "tests/validators/mutators.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

// Messages name lines and numbers that a repair may shift; codes and whom they blame stay.
using Complaint = std::tuple<FindingCode, std::optional<std::int64_t>, std::optional<std::size_t>>;

std::multiset<Complaint> complaints(const std::vector<Finding>& findings) {
  std::multiset<Complaint> result;
  for (const auto& f : findings) result.insert({f.code, f.obstacle, f.segment});
  return result;
}

// Applies each fix alone; returns the codes of the findings that had one.
std::set<FindingCode> hold_to_their_fixes(const std::string& text) {
  const auto before = validate(read_map(text));
  std::set<FindingCode> fixed;
  for (const auto& finding : before) {
    if (finding.fix.empty()) continue;
    const std::string repaired = apply_edits(text, finding.fix);
    const auto after = complaints(validate(read_map(repaired)));
    auto expected = complaints(before);
    expected.erase(expected.find({finding.code, finding.obstacle, finding.segment}));
    EXPECT_TRUE(std::includes(expected.begin(), expected.end(), after.begin(), after.end()))
        << finding_type(finding.code).id << ": " << finding.message << "\n"
        << repaired;
    fixed.insert(finding.code);
  }
  return fixed;
}

TEST(Repairs, OfEveryFixtureHoldTheirPromise) {
  std::set<FindingCode> fixed;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::project_file("tests/fixtures/checks"))) {
    if (entry.path().extension() == ".txt") fixed.merge(hold_to_their_fixes(content(entry.path())));
  }
  using enum FindingCode;
  const std::set<FindingCode> expected{F107, F109, F113, F119, F120, F121, F122, G101, T103, T106};
  EXPECT_EQ(fixed, expected);
}

TEST(Repairs, OfMutantsHoldTheirPromise) {
  Random random(7);
  std::set<FindingCode> fixed;
  for (const auto& mutator : test::mutators()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Map map = test::clean_map(seed);
      if (mutator.mutate(map, random)) fixed.merge(hold_to_their_fixes(format_map(map)));
    }
  }
  using enum FindingCode;
  EXPECT_EQ(fixed, (std::set<FindingCode>{G101, T103, T106}));
}

std::string repaired_once(const std::string& text) {
  const auto findings = validate(read_map(text));
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [](const Finding& f) { return !f.fix.empty(); });
  return found == findings.end() ? "no fix" : apply_edits(text, found->fix);
}

TEST(Repairs, CountSegmentsInAnyLayout) {
  EXPECT_EQ(
      repaired_once("\xEF\xBB\xBF"
                    "border;0;9;9;0;#\r\nobstacle;1;2; 07 ;caf\u00e9;#\r\n1;1;2;2;1;1;x;#\r\n"),
      "\xEF\xBB\xBF"
      "border;0;9;9;0;#\r\nobstacle;1;2; 1 ;caf\u00e9;#\r\n1;1;2;2;1;1;x;#\r\n");
}

TEST(Repairs, CountNothingWhereRecordsAreLost) {
  EXPECT_EQ(
      repaired_once("border;0;9;9;0;#\nobstacle;1;2;3;x;#\n1;1;2;2;1;1;x;#\n1;?;2;2;1;1;x;#\n"),
      "no fix");
}

TEST(Repairs, PutDecimalPointsForCommas) {
  EXPECT_EQ(repaired_once("border;0;9,5;9;0;#\n"), "border;0;9.5;9;0;#\n");
  EXPECT_EQ(repaired_once("border;\u22125;9;9;0;#\n"), "border;-5;9;9;0;#\n");
  EXPECT_EQ(repaired_once("border;0;9 m;9;0;#\n"), "no fix");
}

TEST(Repairs, KeepTheDigitsTheyMove) {
  EXPECT_EQ(repaired_once("border; 9.00 ;0;-1;8.5;#\n"), "border; -1;8.5;9.00;0;#\n");
  EXPECT_EQ(repaired_once("border;1;0;1;9;#\n"), "no fix");
}

TEST(Edits, AreAppliedInOrder) {
  EXPECT_EQ(apply_edits("ab\ncd\n", {{{1, 1}, {1, 2}, "x"}, {{2, 1}, {2, 1}, "--"}}), "xb\n--cd\n");
  EXPECT_EQ(apply_edits("ab", {}), "ab");
}

}  // namespace
}  // namespace mapwright::validators
