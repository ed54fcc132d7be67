// How severe findings are for a site, and within which limits maps are checked.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "validators/deployment/deployment_gate.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// What becomes of a finding: a severity, or nothing.
enum class Level : std::uint8_t { kOff, kNote, kWarning, kError };

/// "off", "note", "warning" or "error"; nothing for other words.
std::optional<Level> parse_level(std::string_view text);

/// A profile with all that it extends. The defaults are the catalogue's and the checks' own.
struct Profile {
  std::string name = "default";

  /// By code; codes without entry follow `by_severity`.
  std::map<FindingCode, Level> levels;
  /// What becomes of findings of severity note, warning, error.
  std::array<Level, 3> by_severity{Level::kNote, Level::kWarning, Level::kError};

  ValidationOptions validation;

  /// What the gate asks of the robot and of the map; absent where the profile says nothing.
  std::optional<double> robot_radius_m, laser_height_m, max_range_m;
  std::optional<double> min_unreachable_m2, min_converged;
};

/// The severity the profile gives a finding; nothing where it turns the finding off.
std::optional<Severity> severity_in(const Profile& profile, const Finding& finding);

/// The limits of the checks, the height of the profile's laser among them.
ValidationOptions validation_options(const Profile& profile);

/// The limits of the profile put into those of a gate; what the profile does not say stays.
void apply_profile(const Profile& profile, GateOptions& options);

/// Name and configuration text of a profile that needs no file.
struct BuiltinProfile {
  std::string_view name;
  std::string_view summary;
  std::string_view yaml;  ///< what stands under the profile's name
};

const std::vector<BuiltinProfile>& builtin_profiles();

}  // namespace mapwright::validators
