#include "validators/deployment/deployment_gate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/navcore/hand_made_maps.hpp"

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
  EXPECT_EQ(codes(outcome.findings), Codes{"N101"});
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

navcore::DeploymentOutcome with_one_area() {
  navcore::DeploymentOutcome outcome;
  outcome.reachability.areas.push_back({50.0, {5, 5}, {0, 0, 10, 10}, true});
  outcome.reachability.largest_fraction = 1.0;
  return outcome;
}

TEST(DeploymentGate, N103ForAPairThatThePlannerMissed) {
  auto outcome = with_one_area();
  outcome.planning = navcore::PlanningTrials{3, 3, {}};
  EXPECT_EQ(codes(deployment_findings(outcome, quick())), Codes{});
  outcome.planning = navcore::PlanningTrials{3, 2, {{{1, 1}, {9, 9}, 500}}};
  const auto findings = deployment_findings(outcome, quick());
  ASSERT_EQ(codes(findings), Codes{"N103"});
  EXPECT_EQ(findings[0].at, (Point{1, 1}));
}

TEST(DeploymentGate, N104WhenTooFewRunsConverge) {
  auto outcome = with_one_area();
  const navcore::LostRun lost{{3, 4, Angle()}, 7.5};
  outcome.localization = navcore::LocalizationTrials{10, 8, 0.1, 7.5, {lost, lost}};
  EXPECT_EQ(codes(deployment_findings(outcome, quick())), Codes{});
  outcome.localization->converged = 7;
  const auto findings = deployment_findings(outcome, quick());
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
}

}  // namespace
}  // namespace mapwright::validators
