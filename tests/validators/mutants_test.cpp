// Clean maps are broken in every catalogued way; each defect must be found at its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/validators/mutators.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {
namespace {

using test::Expected;

constexpr int kMutantsEach = 40;

// Lines of a record of a canonical map, found without the reader's index: records are closed by a
// line "#", the border's is the first.
struct Lines {
  std::size_t first, last;
};

Lines lines_of_record(const std::string& text, std::size_t record) {
  std::size_t line = 1;
  std::size_t at = 0;
  Lines lines{1, 1};
  for (std::size_t closed = 0; at < text.size(); ++line) {
    const std::size_t end = text.find('\n', at);
    if (text.compare(at, end - at, "#") == 0) {
      if (closed == record) return {lines.first, line};
      ++closed;
      lines.first = line + 1;
    }
    at = end + 1;
  }
  return lines;
}

std::size_t record_of(const Map& map, const Expected& expected, const Finding& finding) {
  if (!expected.obstacle) return 0;
  std::size_t record = 1;
  for (std::size_t i = 0; i < *expected.obstacle; ++i) {
    record += 1 + map.obstacles[i].segments.size();
  }
  return record + finding.segment.value_or(0);
}

bool is_expected(const Finding& finding, FindingCode code, const Expected& expected, const Map& map,
                 const std::string& text) {
  if (finding.code != code || !finding.place) return false;
  if (expected.obstacle.has_value() != finding.obstacle.has_value()) return false;
  if (expected.obstacle && *finding.obstacle != map.obstacles[*expected.obstacle].id) return false;
  const auto& segments = expected.segments;
  const bool names_right_segment =
      segments.empty()
          ? !finding.segment
          : finding.segment && std::count(segments.begin(), segments.end(), *finding.segment) > 0;
  const Lines lines = lines_of_record(text, record_of(map, expected, finding));
  return names_right_segment && lines.first <= finding.place->line &&
         finding.place->line <= lines.last;
}

std::string listed(const std::vector<Finding>& findings) {
  std::string text;
  for (const auto& f : findings) {
    text += std::string(finding_type(f.code).id) + " line " +
            std::to_string(f.place.value_or(TextPlace{}).line) + ": " + f.message + "\n";
  }
  return text;
}

TEST(CleanMaps, HaveNoFindings) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto findings = validate(read_map(format_map(test::clean_map(seed))));
    ASSERT_TRUE(findings.empty()) << "seed " << seed << "\n" << listed(findings);
  }
}

TEST(MutatorList, HoldsEveryFindingOfAMap) {
  std::set<FindingCode> mutated;
  for (const auto& mutator : test::mutators()) mutated.insert(mutator.code);
  for (const auto& type : finding_catalogue()) {
    const bool is_of_map = std::string_view("GST").find(type.id.front()) != std::string_view::npos;
    EXPECT_EQ(mutated.count(type.code) > 0, is_of_map) << type.id;
  }
}

class Mutants : public testing::TestWithParam<test::Mutator> {};

TEST_P(Mutants, AreFoundAtTheirPlace) {
  const auto& mutator = GetParam();
  int made = 0;
  for (std::uint64_t seed = 1; made < kMutantsEach; ++seed) {
    Random random(seed, static_cast<std::uint64_t>(mutator.code));
    Map map = test::clean_map(seed);
    const auto expected = mutator.mutate(map, random);
    if (!expected) continue;
    ++made;
    const std::string text = format_map(map);
    const auto findings = validate(read_map(text));
    const bool found = std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
      return is_expected(finding, mutator.code, *expected, map, text);
    });
    ASSERT_TRUE(found) << "seed " << seed << ", position " << expected->obstacle.value_or(SIZE_MAX)
                       << ", segment "
                       << (expected->segments.empty() ? 0 : expected->segments.front()) << "\n"
                       << listed(findings);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Mutants, testing::ValuesIn(test::mutators()),
                         [](const auto& test) {
                           return std::string(finding_type(test.param.code).id);
                         });

}  // namespace
}  // namespace mapwright::validators
