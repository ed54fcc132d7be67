// Private to this folder: profiles out of YAML.
#pragma once

#include "validators/profile/profile.hpp"
#include "validators/profile/yaml_reading.hpp"

namespace mapwright::validators {

/// Reads the profiles of a file; those it does not have are the program's own.
class ProfileReader {
 public:
  /// `profiles`: what stands under that key, null where it is missing.
  ProfileReader(const YAML::Node& profiles, YamlMistakes& mistakes)
      : profiles_(profiles), mistakes_(mistakes) {}

  /// Reads every profile of the file, so that mistakes show in those that nobody chose.
  void read_all();

  bool knows(const std::string& name) const;
  std::vector<std::string_view> names() const;

  /// The profile with all it extends. Requires a name that it knows.
  Profile profile(const std::string& name) { return resolved(name, {}); }

  /// The keys severity, checks and robot, for `profile`; a profile has no others but extends.
  std::vector<YamlKey> setting_keys(Profile& profile);

 private:
  Profile resolved(const std::string& name, std::vector<std::string> through);
  Profile base_of(const YAML::Node& node, std::vector<std::string> through);
  void read_severity(const YAML::Node& node, Profile& profile);
  void read_checks(const YAML::Node& node, Profile& profile);
  void read_check(FindingCode code, const YAML::Node& node, Profile& profile);
  void read_robot(const YAML::Node& node, Profile& profile);
  std::optional<Level> level(const YAML::Node& node);

  YAML::Node profiles_;
  YamlMistakes& mistakes_;
};

/// The code that a text names; reports those there are not.
std::optional<FindingCode> yaml_code(const YAML::Node& node, YamlMistakes& mistakes);

}  // namespace mapwright::validators
