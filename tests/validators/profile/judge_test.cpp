#include "validators/profile/judge.hpp"

#include <gtest/gtest.h>

#include "tests/validators/shapes.hpp"

namespace mapwright::validators {
namespace {

using test::solid;

// Obstacle 2 reaches beyond the border (G109) and has no semantic string (S103); so does 3, which
// lies elsewhere.
MapDocument two_beyond(std::int64_t second = 2, std::int64_t third = 3) {
  Obstacle a = solid(second, {48, 0, 52, 2}), b = solid(third, {-52, 10, -48, 12});
  a.semantic = b.semantic = "";
  return read_map(format_map(Map{{-50.0, 50.0, 50.0, -50.0}, {solid(1, {0, 0, 1, 1}), a, b}}));
}

Date day(const char* text) {
  return parse_date(text).value();
}

Judgement judged(const std::string& yaml, const char* today = "2026-06-01",
                 std::string_view path = "north/map.txt") {
  const MapDocument document = two_beyond();
  const Policy policy = read_policy(yaml, "c.yaml").value();
  return judge(validate(document), {document, policy, day(today), path});
}

std::string text_of(const std::vector<Finding>& findings) {
  std::string text;
  for (const auto& f : findings) {
    text +=
        std::string(finding_type(f.code).id) + ":" + std::to_string(f.obstacle.value_or(0)) + " ";
  }
  return text;
}

// What is left when this stands in a suppression.
std::string left_by(const std::string& keys, std::string_view path = "north/map.txt") {
  return text_of(
      judged("suppressions:\n- {reason: x, " + keys + "}\n", "2026-06-01", path).findings);
}

constexpr const char* kAll = "S103:2 G109:2 S103:3 G109:3 ";

TEST(Judge, WithoutConfigurationLeavesAllAsItIs) {
  const auto judgement = judged("");
  EXPECT_EQ(text_of(judgement.findings), kAll);
  EXPECT_EQ(judgement.names.size(), 4U);
  EXPECT_TRUE(judgement.suppressed.empty());
}

TEST(Judge, GivesSeveritiesAndDropsWhatIsOff) {
  const auto judgement = judged("checks: {S103: off, G109: note}\n");
  EXPECT_EQ(text_of(judgement.findings), "G109:2 G109:3 ");
  EXPECT_EQ(judgement.findings.front().severity, Severity::kNote);
}

TEST(Judge, SuppressesByWhatIsNamed) {
  EXPECT_EQ(left_by("code: G109"), "S103:2 S103:3 ");
  EXPECT_EQ(left_by("code: [G109, S103]"), "");
  EXPECT_EQ(left_by("code: G109, obstacle: 2"), "S103:2 S103:3 G109:3 ");
  EXPECT_EQ(left_by("code: G109, obstacle: 2, segment: 1"), "S103:2 S103:3 G109:3 ");
  EXPECT_EQ(left_by("code: G109, obstacle: 2, segment: 3"), kAll);
  EXPECT_EQ(left_by("code: G109, region: [40, -10, 60, 10]"), "S103:2 S103:3 G109:3 ");
  EXPECT_EQ(left_by("code: G109, path: north/*"), "S103:2 S103:3 ");
  EXPECT_EQ(left_by("code: G109, path: south/*"), kAll);
  EXPECT_EQ(left_by("code: G104"), kAll);
}

TEST(Judge, SuppressesByFingerprint) {
  const auto all = judged("");
  EXPECT_EQ(left_by("code: G109, fingerprint: " + all.names[1].place), "S103:2 S103:3 G109:3 ");
  EXPECT_EQ(left_by("code: G109, fingerprint: " + all.names[3].subject), "S103:2 G109:2 S103:3 ");
}

TEST(Judge, SaysWhoSuppressedWhat) {
  const auto judgement = judged("suppressions:\n  - {code: G109, obstacle: 3, reason: why not}\n");
  ASSERT_EQ(judgement.suppressed.size(), 1U);
  EXPECT_EQ(judgement.suppressed[0].finding.obstacle, 3);
  EXPECT_EQ(judgement.suppressed[0].by, "c.yaml:2:5");
  EXPECT_EQ(judgement.suppressed[0].reason, "why not");
}

constexpr const char* kUntil =
    "suppressions:\n- {code: G109, reason: x, until: 2027-01-01}\n- {code: T101, reason: y}\n";

TEST(Judge, SuppressionsHoldOnTheirLastDay) {
  EXPECT_EQ(text_of(judged(kUntil, "2027-01-01").findings), "S103:2 S103:3 ");
  EXPECT_EQ(text_of(judged(kUntil, "2027-01-02").findings), kAll);
}

TEST(PolicyFindings, TellOfUnusedAndExpiredSuppressions) {
  const Policy policy = read_policy(kUntil, "c.yaml").value();
  const auto before = policy_findings(policy, {"c.yaml:2:3"}, true, day("2027-01-01"));
  ASSERT_EQ(before.size(), 1U);
  EXPECT_EQ(before[0].code, FindingCode::C301);
  EXPECT_EQ(before[0].place, (TextPlace{3, 3}));
  const auto after = policy_findings(policy, {}, false, day("2027-01-02"));
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].code, FindingCode::C302);
  EXPECT_EQ(after[0].place, (TextPlace{2, 3}));
  EXPECT_TRUE(
      policy_findings(policy, {"c.yaml:2:3", "c.yaml:3:3"}, true, day("2026-01-01")).empty());
}

TEST(PolicyFindings, HaveTheProfilesSeverities) {
  const Policy policy = read_policy(std::string(kUntil) + "checks: {C301: error}\n", "c").value();
  EXPECT_EQ(policy_findings(policy, {"c:2:3"}, true, day("2026-01-01"))[0].severity,
            Severity::kError);
}

TEST(Globs, MatchPaths) {
  EXPECT_TRUE(glob_matches("*.txt", "a/b/map.txt"));
  EXPECT_TRUE(glob_matches("a/*/map.txt", "a/b/map.txt"));
  EXPECT_FALSE(glob_matches("a/*.txt", "a/b/map.txt"));
  EXPECT_TRUE(glob_matches("**/map.txt", "map.txt"));
  EXPECT_TRUE(glob_matches("**/map.txt", "a/b/map.txt"));
  EXPECT_TRUE(glob_matches("a/**/map.txt", "a/b/c/map.txt"));
  EXPECT_TRUE(glob_matches("a/**/map.txt", "a/map.txt"));
  EXPECT_FALSE(glob_matches("b/**/map.txt", "a/map.txt"));
  EXPECT_TRUE(glob_matches("m[a-c]p.txt", "map.txt"));
  EXPECT_FALSE(glob_matches("m?p", "map.txt"));
}

std::vector<KnownFinding> known_of(const MapDocument& document) {
  const auto findings = validate(document);
  const auto names = fingerprints(document, findings);
  std::vector<KnownFinding> known;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    known.push_back({findings[i].code, names[i], findings[i].message});
  }
  return known;
}

std::string news_in(const MapDocument& document, const std::vector<KnownFinding>& known) {
  const Policy policy = read_policy("", "").value();
  const auto judgement =
      judge(validate(document), {document, policy, day("2026-06-01"), "map.txt", &known, "base"});
  for (const auto& suppressed : judgement.suppressed) EXPECT_EQ(suppressed.by, "base");
  return text_of(judgement.findings);
}

TEST(Baseline, KnowsFindingsOfRenumberedObstacles) {
  EXPECT_EQ(news_in(two_beyond(7, 2), known_of(two_beyond())), "");
}

TEST(Baseline, KnowsFindingsOfMovedObstacles) {
  MapDocument moved = two_beyond();
  Map map = moved.map;
  for (auto& s : map.obstacles[1].segments) {
    s.a.y += 3.0;
    s.b.y += 3.0;
  }
  EXPECT_EQ(news_in(read_map(format_map(map)), known_of(two_beyond())), "");
}

TEST(Baseline, LetsNewFindingsThrough) {
  auto known = known_of(two_beyond());
  known.erase(known.begin());
  EXPECT_EQ(news_in(two_beyond(), known), "S103:2 ");
  EXPECT_EQ(news_in(two_beyond(), {}), kAll);
}

TEST(Baseline, IsWhatItsFileSays) {
  Baseline baseline;
  const auto known = known_of(two_beyond());
  baseline.add("b.txt", known);
  baseline.add("a.txt", {});
  const auto read = Baseline::parse(baseline.text());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->findings("b.txt"), known);
  EXPECT_TRUE(read->findings("c.txt").empty());
  EXPECT_EQ(read->text(), baseline.text());
}

TEST(Baseline, SaysWhatIsNone) {
  EXPECT_FALSE(Baseline::parse(""));
  EXPECT_FALSE(Baseline::parse("{}"));
  EXPECT_FALSE(Baseline::parse("[1]"));
  EXPECT_FALSE(Baseline::parse(R"({"schema": "mapwright.baseline/1", "maps": [{"path": 3}]})"));
}

}  // namespace
}  // namespace mapwright::validators
