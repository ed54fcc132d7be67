#include "validators/profile/profile.hpp"

namespace mapwright::validators {

std::optional<Level> parse_level(std::string_view text) {
  if (text == "off") return Level::kOff;
  if (text == "note") return Level::kNote;
  if (text == "warning") return Level::kWarning;
  if (text == "error") return Level::kError;
  return std::nullopt;
}

std::optional<Severity> severity_in(const Profile& profile, const Finding& finding) {
  const auto own = profile.levels.find(finding.code);
  const Level level = own != profile.levels.end()
                          ? own->second
                          : profile.by_severity[static_cast<std::size_t>(finding.severity)];
  switch (level) {
    case Level::kOff:
      return std::nullopt;
    case Level::kNote:
      return Severity::kNote;
    case Level::kWarning:
      return Severity::kWarning;
    case Level::kError:
      return Severity::kError;
  }
  return finding.severity;
}

ValidationOptions validation_options(const Profile& profile) {
  ValidationOptions options = profile.validation;
  options.laser_height_m = profile.laser_height_m.value_or(options.laser_height_m);
  return options;
}

void apply_profile(const Profile& profile, GateOptions& options) {
  options.validation = profile.validation;
  auto& robot = options.deployment;
  auto& laser = robot.localization.laser;
  robot.robot_radius_m = profile.robot_radius_m.value_or(robot.robot_radius_m);
  laser.height_m = profile.laser_height_m.value_or(laser.height_m);
  laser.max_range_m = profile.max_range_m.value_or(laser.max_range_m);
  options.min_unreachable_m2 = profile.min_unreachable_m2.value_or(options.min_unreachable_m2);
  options.min_converged = profile.min_converged.value_or(options.min_converged);
}

const std::vector<BuiltinProfile>& builtin_profiles() {
  static const std::vector<BuiltinProfile> profiles{
      {"default", "severities and limits as the pages of the findings say", "{}"},
      {"report", "what the technical report asks for; what else this project looks for is a note",
       R"(
severity: {warning: note}
checks:
  S105: warning
  T201: warning
  T202: warning
)"},
      {"strict", "for delivery: a warning is an error, a note a warning",
       R"(
severity: {note: warning, warning: error}
)"},
      {"authoring", "while a map is being drawn: what is unfinished is a warning",
       R"(
checks:
  F113: warning
  G105: warning
  G106: warning
  G109: warning
  G112: warning
  S103: note
  S105: warning
  T102: warning
  T201: warning
)"}};
  return profiles;
}

}  // namespace mapwright::validators
