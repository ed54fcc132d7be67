#include "validators/deployment/deployment_gate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/navcore/hand_made_maps.hpp"
#include "tests/support/data.hpp"
#include "validators/check_pages.hpp"
#include "validators/deployment/localizability_findings.hpp"

namespace mapwright::validators {
namespace {

using namespace mapwright::test;

GateOptions quick() {
  GateOptions options;
  options.deployment.plans = 5;
  options.deployment.localization_trials = 0;
  return options;
}

GateOutcome check(const Map& map, const GateOptions& options = quick()) {
  return check_deployment(read_map(format_map(map)), options);
}

std::vector<std::string_view> codes(const std::vector<Finding>& findings) {
  std::vector<std::string_view> codes;
  for (const auto& finding : findings) codes.push_back(finding_type(finding.code).id);
  return codes;
}

using Codes = std::vector<std::string_view>;

TEST(DeploymentGate, GoodMapPasses) {
  const auto outcome = check(map10({box(1, 4, 4, 6, 6)}));
  EXPECT_EQ(codes(outcome.findings), Codes{});
  EXPECT_TRUE(outcome.passes());
}

TEST(DeploymentGate, N101WhereTheRobotCannotStand) {
  const auto outcome = check(map10({box(1, 0, 0, 10, 10)}));
  EXPECT_EQ(codes(outcome.findings), (Codes{"G126", "N101"}));
  EXPECT_FALSE(outcome.passes());
}

TEST(DeploymentGate, N101AlsoWhereTheRobotIsTooLarge) {
  GateOptions options = quick();
  options.deployment.robot_radius_m = 4.0;
  EXPECT_EQ(codes(check(map10({box(1, 4, 4, 6, 6)}), options).findings), Codes{"N101"});
  options.deployment.robot_radius_m = 1.9;
  EXPECT_EQ(codes(check(map10({box(1, 4, 4, 6, 6)}), options).findings), Codes{});
}

Map with_courtyard() {
  return map10({box(1, 1, 1, 6, 6), hollow(2, 2, 2, 5, 5, "court,inner_of=1")});
}

TEST(DeploymentGate, N102ForACourtyardWithoutGate) {
  const auto outcome = check(with_courtyard());
  ASSERT_EQ(codes(outcome.findings), Codes{"N102"});
  EXPECT_TRUE(outcome.passes());
  const Finding& finding = outcome.findings.front();
  ASSERT_TRUE(finding.at.has_value());
  EXPECT_TRUE(Box({2, 2, 5, 5}).contains(*finding.at));
  EXPECT_NE(finding.message.find("0.3 m"), std::string::npos) << finding.message;
}

TEST(DeploymentGate, NoN102ForACourtyardWithAGateOrASmallOne) {
  Map gate = with_courtyard();
  gate.obstacles = {ring(1, {{1, 1},
                             {3, 1},
                             {3, 2},
                             {2, 2},
                             {2, 5},
                             {5, 5},
                             {5, 2},
                             {4, 2},
                             {4, 1},
                             {6, 1},
                             {6, 6},
                             {1, 6}})};
  EXPECT_EQ(codes(check(gate).findings), Codes{});
  GateOptions options = quick();
  options.min_unreachable_m2 = 6.0;  // the court has 2.4 m × 2.4 m for the robot's centre
  EXPECT_EQ(codes(check(with_courtyard(), options).findings), Codes{});
}

std::string fixture(const std::string& name) {
  std::ifstream in(test::project_file("tests/fixtures/checks/" + name), std::ios::binary);
  EXPECT_TRUE(in) << name;
  return {std::istreambuf_iterator<char>(in), {}};
}

// Family N needs a robot, so its fixtures are run here: that of a place also has what cuts it off.
TEST(DeploymentGate, FixturesTriggerAndNearMissesDoNot) {
  const auto codes_of = [](const std::string& name) {
    return codes(check_deployment(read_map(fixture(name)), quick()).findings);
  };
  EXPECT_EQ(codes_of("N105.txt"), (Codes{"N106", "N105"}));
  EXPECT_EQ(codes_of("N105.ok.txt"), Codes{});
  EXPECT_EQ(codes_of("N106.txt"), Codes{"N106"});
  EXPECT_EQ(codes_of("N106.ok.txt"), Codes{});
}

// What scans can tell: only where it is asked for.
TEST(DeploymentGate, FixturesOfLocalizability) {
  GateOptions options = quick();
  options.deployment.plans = 0;
  options.deployment.localizability_places = 1000;
  const auto codes_of = [&](const std::string& name) {
    return codes(check_deployment(read_map(fixture(name)), options).findings);
  };
  EXPECT_EQ(codes_of("N107.txt"), Codes{"N107"});
  EXPECT_EQ(codes_of("N107.ok.txt"), Codes{});
  EXPECT_EQ(codes_of("N108.txt"), (Codes{"N108", "N108"}));
  EXPECT_EQ(codes_of("N108.ok.txt"), Codes{});
}

TEST(DeploymentGate, N107SaysWhereAlongWhichDirectionAndForHowLong) {
  GateOptions options = quick();
  options.deployment.localizability_places = 1000;
  const auto outcome = check_deployment(read_map(fixture("N107.txt")), options);
  ASSERT_EQ(codes(outcome.findings), Codes{"N107"});
  const Finding& finding = outcome.findings.front();
  ASSERT_TRUE(finding.at.has_value());
  EXPECT_TRUE(Box({25, 0, 35, 3}).contains(*finding.at));
  EXPECT_NE(finding.message.find("along direction 0°"), std::string::npos) << finding.message;
  EXPECT_NE(finding.message.find("odometry for 3"), std::string::npos) << finding.message;
  ASSERT_EQ(finding.geometry.areas.size(), 1U);
  ASSERT_TRUE(outcome.deployment->localizability.has_value());
}

// A single row of places beside a long wall, which scans tell to `accuracy_m` along it.
std::string text_of_weak_row(double accuracy_m) {
  navcore::LocalizabilityField field;
  field.grid = navcore::PlaceGrid::over(Box{0.0, 0.0, 10.0, 0.5}, 0.5);
  navcore::WeakArea area;
  for (std::size_t i = 0; i < 20; ++i) area.cells.push_back(i);
  area.accuracy_m = accuracy_m;
  field.accuracy.resize(20);
  field.accuracy[area.middle].edges_median.with_edges.minor_m = 0.01;
  return weak_area_text(field, area);
}

TEST(DeploymentGate, N107GivesNoBoundThatIsLongerThanTheArea) {
  EXPECT_NE(text_of_weak_row(3.1).find("no better than to 3.1 m"), std::string::npos);
  const std::string longer = text_of_weak_row(75.3);
  EXPECT_NE(longer.find("does not tell the position along direction 0°"), std::string::npos);
  EXPECT_EQ(longer.find("75"), std::string::npos) << longer;
}

TEST(DeploymentGate, PagesShowTheFixtures) {
  for (const auto code :
       {FindingCode::N105, FindingCode::N106, FindingCode::N107, FindingCode::N108}) {
    for (const auto* ending : {".txt", ".ok.txt"}) {
      const std::string text = fixture(std::string(finding_type(code).id) + ending);
      EXPECT_NE(check_page(code).find("```\n" + text + "```\n"), std::string::npos) << ending;
    }
  }
}

TEST(DeploymentGate, N106NamesThePlaceAndBothObstacles) {
  const MapDocument document = read_map(fixture("N106.txt"));
  const auto findings = check_deployment(document, quick()).findings;
  ASSERT_EQ(codes(findings), Codes{"N106"});
  const Finding& finding = findings[0];
  EXPECT_NEAR(finding.at->y, 4.25, 1e-9);
  ASSERT_EQ(finding.geometry.lines.size(), 1U);
  EXPECT_NEAR(distance(finding.geometry.lines[0][0], finding.geometry.lines[0][1]), 0.5, 1e-9);
  EXPECT_NE(finding.message.find("0.5 m wide"), std::string::npos) << finding.message;
  EXPECT_NE(finding.message.find("of obstacle 1 (wall)"), std::string::npos) << finding.message;
  EXPECT_NE(finding.message.find("of obstacle 2 (wall)"), std::string::npos) << finding.message;
  ASSERT_TRUE(finding.obstacle && finding.segment && finding.place);
  const std::size_t position = *finding.obstacle == 1 ? 0 : 1;
  EXPECT_EQ(*finding.place,
            document.index.place(document.text, position, *finding.segment - 1, SegmentField::kAx));
}

TEST(DeploymentGate, N105StandsBesideThePlace) {
  const auto outcome = check_deployment(read_map(fixture("N105.txt")), quick());
  const Finding& finding = outcome.findings.back();
  EXPECT_EQ(finding.obstacle, 6);
  EXPECT_TRUE(Box({14.5, 2.5, 18, 7.5}).contains(*finding.at));
  EXPECT_NE(finding.message.find("'Reading bench'"), std::string::npos) << finding.message;
  EXPECT_NE(finding.message.find("0.55 m wide"), std::string::npos) << finding.message;
}

TEST(DeploymentGate, N105WhereThereIsNoRoomBesideThePlace) {
  Map site = map10({box(1, 4, 4, 6, 6), box(2, 1, 1, 9, 9)});
  site.obstacles[0].semantic = "bench,name=Walled in";
  const auto findings = check(site).findings;
  EXPECT_EQ(codes(findings).back(), "N105");
  EXPECT_NE(findings.back().message.find("no room"), std::string::npos);
}

TEST(DeploymentGate, OneGapBeforeTwoAreasIsOneN106) {
  // A yard behind a narrow gate, and a yard behind a narrow gate of that yard.
  const auto outcome =
      check(map({0, 10, 30, 0},
                {box(1, 9.9, 0, 10.1, 4), box(2, 9.9, 4.4, 10.1, 10), box(3, 19.9, 0, 20.1, 4),
                 box(4, 19.9, 4.5, 20.1, 10), box(5, 24, 0, 24.2, 10)}));
  std::size_t areas = 0, gaps = 0;
  for (const auto code : codes(outcome.findings)) {
    areas += code == "N102" ? 1U : 0U;
    gaps += code == "N106" ? 1U : 0U;
  }
  EXPECT_EQ(areas, 1U);  // the easternmost yard is closed
  EXPECT_EQ(gaps, 1U);   // the narrower one is to blame for both others
  EXPECT_NE(outcome.findings.back().message.find("2 areas of"), std::string::npos);
  EXPECT_EQ(outcome.findings.back().geometry.points.size(), 2U);
}

TEST(DeploymentGate, SaysWhyNothingCouldBeRun) {
  const auto outcome = check(map10({box(1, 2e6, 4, 2e6 + 1, 6)}));
  ASSERT_TRUE(outcome.deployment.has_value());
  const auto sections = deployment_sections(outcome, quick());
  EXPECT_EQ(sections[2].json, "null");
  EXPECT_NE(sections[2].line.find("500 km"), std::string::npos) << sections[2].line;
}

navcore::DeploymentOutcome with_one_area() {
  navcore::DeploymentOutcome outcome;
  outcome.reachability.areas.push_back({50.0, {5, 5}, {0, 0, 10, 10}, {}});
  outcome.reachability.largest_fraction = 1.0;
  return outcome;
}

TEST(DeploymentGate, N103ForAPairThatThePlannerMissed) {
  auto outcome = with_one_area();
  outcome.planning = navcore::PlanningTrials{3, 3, {}};
  EXPECT_EQ(codes(deployment_findings({}, outcome, quick())), Codes{});
  outcome.planning = navcore::PlanningTrials{3, 2, {{{1, 1}, {9, 9}, 500}}};
  const auto findings = deployment_findings({}, outcome, quick());
  ASSERT_EQ(codes(findings), Codes{"N103"});
  EXPECT_EQ(findings[0].at, (Point{1, 1}));
}

TEST(DeploymentGate, N104WhenTooFewRunsConverge) {
  auto outcome = with_one_area();
  const navcore::LostRun lost{{3, 4, Angle()}, 7.5};
  outcome.localization = navcore::LocalizationTrials{10, 8, 0.1, 7.5, {lost, lost}};
  EXPECT_EQ(codes(deployment_findings({}, outcome, quick())), Codes{});
  outcome.localization->converged = 7;
  const auto findings = deployment_findings({}, outcome, quick());
  ASSERT_EQ(codes(findings), Codes{"N104"});
  EXPECT_EQ(findings[0].at, (Point{3, 4}));
}

TEST(DeploymentGate, ValidationFindingsComeFirstAndFail) {
  Map map = with_courtyard();
  map.obstacles.push_back(hollow(3, 7, 7, 8, 8, "bench"));  // runs the wrong way round
  const auto outcome = check(map);
  EXPECT_FALSE(outcome.passes());
  EXPECT_EQ(codes(outcome.findings).front(), "G107");
  EXPECT_EQ(codes(outcome.findings).back(), "N102");
}

TEST(DeploymentGate, WithoutABorderNothingIsRun) {
  const auto outcome = check(map({10, 0, 0, 10}, {box(1, 4, 4, 6, 6)}));
  EXPECT_FALSE(outcome.passes());
  EXPECT_FALSE(outcome.deployment.has_value());
  const auto sections = deployment_sections(outcome, quick());
  for (const auto& section : sections) {
    EXPECT_EQ(section.json, section.key.empty() ? "" : "null");
  }
}

TEST(DeploymentGate, SectionsNameGapsAndPlaces) {
  const auto outcome = check_deployment(read_map(fixture("N105.txt")), quick());
  const auto json = nlohmann::ordered_json::parse(deployment_sections(outcome, quick())[2].json);
  const auto& gap = json["unreachable"][0]["gap"];
  EXPECT_NEAR(gap["width_m"], 0.55, 1e-12);
  EXPECT_EQ(gap["between"][0]["obstacle"].get<int>() + gap["between"][1]["obstacle"].get<int>(), 9);
  EXPECT_TRUE(gap["between"][0]["segment"].is_number());
  EXPECT_EQ(json["places"], 1);
  EXPECT_EQ(json["places_cut_off"][0]["name"], "Reading bench");
  EXPECT_EQ(json["places_cut_off"][0]["gap"], gap);
}

TEST(DeploymentGate, SectionsHaveTheKeysOfTheContract) {
  auto outcome = check(with_courtyard());
  outcome.deployment->localization = navcore::LocalizationTrials{10, 9, 0.1, 0.4, {}};
  std::string text = "{";
  for (const auto& section : deployment_sections(outcome, quick())) {
    if (section.key.empty()) continue;
    text += (text == "{" ? "\"" : ",\"") + section.key + "\":" + section.json;
  }
  const auto json = nlohmann::ordered_json::parse(text + "}");
  EXPECT_EQ(json["localization"]["trials"], 10);
  EXPECT_EQ(json["localization"]["converged"], 9);
  EXPECT_EQ(json["localization"]["position_error_m"]["median"], 0.1);
  EXPECT_EQ(json["localization"]["position_error_m"]["p95"], 0.4);
  EXPECT_EQ(json["planning"]["trials"], 5);
  EXPECT_EQ(json["planning"]["solved"], 5);
  EXPECT_EQ(json["reachability"]["radius_m"], 0.3);
  EXPECT_EQ(json["reachability"]["components"], 2);
  EXPECT_GT(json["reachability"]["largest_fraction"], 0.8);
  ASSERT_EQ(json["reachability"]["unreachable"].size(), 1U);
  EXPECT_NEAR(json["reachability"]["unreachable"][0]["area_m2"], 2.4 * 2.4, 0.5);
  EXPECT_TRUE(json["reachability"]["unreachable"][0]["gap"].is_null());
  EXPECT_EQ(json["reachability"]["places"], 0);
  EXPECT_TRUE(json["reachability"]["places_cut_off"].empty());
}

}  // namespace
}  // namespace mapwright::validators
