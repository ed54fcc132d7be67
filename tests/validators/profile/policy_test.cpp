#include "validators/profile/policy.hpp"

#include <gtest/gtest.h>

namespace mapwright::validators {
namespace {

Policy policy_of(const std::string& yaml, std::string_view profile = "") {
  const auto policy = read_policy(yaml, "c.yaml", profile);
  EXPECT_TRUE(policy) << policy.error().message;
  return policy.value_or(Policy{});
}

std::string mistakes_of(const std::string& yaml) {
  const auto policy = read_policy(yaml, "c.yaml");
  EXPECT_FALSE(policy);
  if (policy) return "";
  EXPECT_EQ(policy.error().kind, FailureKind::kInput);
  return policy.error().message;
}

std::optional<Severity> severity_of(const Policy& policy, FindingCode code) {
  return severity_in(policy.profile, make_finding(code, ""));
}

TEST(Policy, OfNoTextIsTheCatalogues) {
  const Policy policy = policy_of("");
  EXPECT_EQ(policy.profile.name, "default");
  EXPECT_TRUE(policy.suppressions.empty());
  for (const auto& type : finding_catalogue()) {
    EXPECT_EQ(severity_of(policy, type.code), type.severity);
  }
  EXPECT_EQ(policy.profile.validation.max_ramp_slope_deg, ValidationOptions{}.max_ramp_slope_deg);
}

TEST(Policy, EveryBuiltinProfileCanBeRead) {
  for (const auto& profile : builtin_profiles()) {
    EXPECT_EQ(policy_of("", profile.name).profile.name, profile.name);
  }
}

TEST(Policy, StrictRaisesSeverities) {
  const Policy policy = policy_of("", "strict");
  EXPECT_EQ(severity_of(policy, FindingCode::G108), Severity::kError);
  EXPECT_EQ(severity_of(policy, FindingCode::C202), Severity::kWarning);
  EXPECT_EQ(severity_of(policy, FindingCode::G104), Severity::kError);
}

TEST(Policy, ReportAsksForWhatTheReportAsksFor) {
  const Policy policy = policy_of("", "report");
  EXPECT_EQ(severity_of(policy, FindingCode::G108), Severity::kNote);
  EXPECT_EQ(severity_of(policy, FindingCode::T201), Severity::kWarning);
  EXPECT_EQ(severity_of(policy, FindingCode::F113), Severity::kError);
}

TEST(Policy, SetsSeveritiesAndLimitsByCode) {
  const Policy policy = policy_of(
      "checks:\n  G108: {severity: error, depth_m: 0.05}\n  S103: off\n  T204: {max_slope_deg: 8}\n"
      "  N102: {min_area_m2: 4}\n"
      "robot: {radius_m: 0.45, laser_height_m: 0.3}\n");
  EXPECT_EQ(severity_of(policy, FindingCode::G108), Severity::kError);
  EXPECT_EQ(severity_of(policy, FindingCode::S103), std::nullopt);
  EXPECT_EQ(policy.profile.validation.overlap_depth_m, 0.05);
  EXPECT_EQ(policy.profile.validation.max_ramp_slope_deg, 8.0);

  GateOptions options;
  apply_profile(policy.profile, options);
  EXPECT_EQ(options.validation.overlap_depth_m, 0.05);
  EXPECT_EQ(options.deployment.robot_radius_m, 0.45);
  EXPECT_EQ(options.deployment.localization.laser.height_m, 0.3);
  EXPECT_EQ(options.deployment.localization.laser.max_range_m, 15.0);
  EXPECT_EQ(options.min_unreachable_m2, 4.0);
  EXPECT_EQ(options.min_converged, GateOptions{}.min_converged);
}

constexpr const char* kTwoProfiles =
    "profile: site\n"
    "profiles:\n"
    "  site: {extends: strict, checks: {S103: note}}\n"
    "  strict: {extends: strict, checks: {S104: off, S103: off}}\n";

TEST(Policy, ProfilesExtendOthersAndMayTakeABuiltinName) {
  const Policy policy = policy_of(kTwoProfiles);
  EXPECT_EQ(policy.profile.name, "site");
  EXPECT_EQ(severity_of(policy, FindingCode::S103), Severity::kNote);
  EXPECT_EQ(severity_of(policy, FindingCode::S104), std::nullopt);
  EXPECT_EQ(severity_of(policy, FindingCode::G108), Severity::kError);
}

TEST(Policy, TheCallerMayChooseAnotherProfile) {
  const Policy policy = policy_of(kTwoProfiles, "authoring");
  EXPECT_EQ(severity_of(policy, FindingCode::G109), Severity::kWarning);
  const auto missing = read_policy(kTwoProfiles, "c.yaml", "sit");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, FailureKind::kUsage);
  EXPECT_EQ(missing.error().message, "there is no profile 'sit'; did you mean site?");
}

TEST(Policy, WhatStandsOutsideOfProfilesComesOnTop) {
  const Policy policy =
      policy_of("profiles: {a: {checks: {G108: off}}}\nprofile: a\nchecks: {G108: note}\n");
  EXPECT_EQ(severity_of(policy, FindingCode::G108), Severity::kNote);
}

TEST(Policy, ReadsSuppressions) {
  const Policy policy = policy_of(
      "suppressions:\n"
      "  - code: [G108, G109]\n"
      "    obstacle: -3\n"
      "    segment: 2\n"
      "    region: [5, 8, 1, 2]\n"
      "    path: north/*.txt\n"
      "    fingerprint: 0123456789abcdef\n"
      "    reason: because\n"
      "    until: 2027-01-01\n");
  ASSERT_EQ(policy.suppressions.size(), 1U);
  const auto& s = policy.suppressions.front();
  EXPECT_EQ(s.codes, (std::vector{FindingCode::G108, FindingCode::G109}));
  EXPECT_EQ(s.obstacle, -3);
  EXPECT_EQ(s.segment, 2U);
  EXPECT_EQ(s.region, (Box{1, 2, 5, 8}));
  EXPECT_EQ(s.path, "north/*.txt");
  EXPECT_EQ(s.fingerprint, "0123456789abcdef");
  EXPECT_EQ(s.reason, "because");
  EXPECT_EQ(s.until, parse_date("2027-01-01"));
  EXPECT_EQ(s.place, (TextPlace{2, 5}));
}

TEST(PolicyMistakes, NameLineAndColumn) {
  EXPECT_EQ(
      mistakes_of("suppressions:\n  - code: G108\n    obstacle: 3\n"),
      "c.yaml:2:5: error: the suppression gives no reason; write why the finding is accepted");
  EXPECT_EQ(mistakes_of("chekcs: {}\n"),
            "c.yaml:1:1: error: there is no key 'chekcs'; did you mean checks?");
  EXPECT_EQ(mistakes_of("checks:\n  G1008: off\n"),
            "c.yaml:2:3: error: there is no finding 'G1008'; did you mean G108?");
  EXPECT_EQ(mistakes_of("checks: {obstacles_overlap: off}\n"),
            "c.yaml:1:10: error: write the code G108 for obstacles_overlap");
  EXPECT_EQ(mistakes_of("checks: {G108: {depth: 1}}\n"),
            "c.yaml:1:17: error: there is no key 'depth'; did you mean depth_m?");
  EXPECT_EQ(mistakes_of("checks: {G108: warn}\n"),
            "c.yaml:1:16: error: there is no severity 'warn'; there are off, note, warning, error");
  EXPECT_EQ(mistakes_of("robot: {radius_m: -1}\n"), "c.yaml:1:19: error: -1 is not from 0 to 1000");
  EXPECT_EQ(mistakes_of("robot: {radius_m: 1, radius_m: 2}\n"),
            "c.yaml:1:22: error: 'radius_m' stands here a second time");
}

TEST(PolicyMistakes, AreToldAllAtOnceInTheirOrder) {
  EXPECT_EQ(mistakes_of("robot: {radius_m: x}\nprofile: strct\nchecks: {Q1: off}\n"),
            "c.yaml:1:19: error: 'x' is not a number\n"
            "c.yaml:2:10: error: there is no profile 'strct'; did you mean strict?\n"
            "c.yaml:3:10: error: there is no finding 'Q1'");
}

TEST(PolicyMistakes, ShowInProfilesThatNobodyChose) {
  EXPECT_EQ(mistakes_of("profiles:\n  a: {checks: {G108: oof}}\n"),
            "c.yaml:2:22: error: there is no severity 'oof'; did you mean off?");
}

TEST(PolicyMistakes, OfProfilesThatExtendEachOther) {
  const auto text = mistakes_of("profiles:\n  a: {extends: b}\n  b: {extends: a}\n");
  EXPECT_NE(text.find("c.yaml:2:6: error: the profile 'a' extends itself"), text.npos) << text;
}

TEST(PolicyMistakes, OfYamlItself) {
  EXPECT_EQ(mistakes_of("checks: [\n").substr(0, 9), "c.yaml:2:");
  EXPECT_EQ(mistakes_of("- a\n"), "c.yaml:1:1: error: expected lines 'key: value' here");
  EXPECT_EQ(mistakes_of("suppressions: yes\n"),
            "c.yaml:1:15: error: expected a list of suppressions here, each behind a '-'");
}

TEST(PolicyMistakes, OfSuppressions) {
  const std::string head = "suppressions:\n- ";
  EXPECT_EQ(mistakes_of(head + "{code: G108, reason: x, until: 2027-02-30}\n"),
            "c.yaml:2:34: error: '2027-02-30' is no day; write it as 2027-01-31");
  EXPECT_EQ(mistakes_of(head + "{reason: x}\n"),
            "c.yaml:2:3: error: the suppression names no code; write which finding it is about");
  EXPECT_EQ(mistakes_of(head + "{code: G108, reason: x, segment: 2}\n"),
            "c.yaml:2:36: error: a segment needs the obstacle it belongs to");
  EXPECT_EQ(mistakes_of(head + "{code: G108, reason: x, region: [1, 2]}\n"),
            "c.yaml:2:35: error: expected [x1, y1, x2, y2] in metres here, two opposite corners");
  EXPECT_EQ(mistakes_of(head + "{code: [], reason: x}\n"),
            "c.yaml:2:10: error: the list holds no code");
}

}  // namespace
}  // namespace mapwright::validators
