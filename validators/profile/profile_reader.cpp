#include "validators/profile/profile_reader.hpp"

#include <algorithm>

#include "mapcore/text/characters.hpp"

namespace mapwright::validators {
namespace {

const BuiltinProfile* find_builtin(std::string_view name) {
  const auto& all = builtin_profiles();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const BuiltinProfile& p) { return p.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<YamlKey> parameter_keys(FindingCode code, Profile& profile, YamlMistakes& mistakes) {
  std::vector<YamlKey> keys;
#define MAPWRIGHT_PARAMETER(of_code, key, member, least, most)                           \
  if (code == FindingCode::of_code) {                                                    \
    keys.push_back({#key, [&](const YAML::Node& node) {                                  \
                      if (const auto value = yaml_number(node, least, most, mistakes)) { \
                        profile.member = *value;                                         \
                      }                                                                  \
                    }});                                                                 \
  }
#define MAPWRIGHT_ROBOT_PARAMETER(key, member, least, most)
#include "validators/profile/parameters.def"
#undef MAPWRIGHT_ROBOT_PARAMETER
#undef MAPWRIGHT_PARAMETER
  return keys;
}

}  // namespace

std::optional<FindingCode> yaml_code(const YAML::Node& node, YamlMistakes& mistakes) {
  const auto text = yaml_text(node, mistakes);
  if (!text) return std::nullopt;
  if (const auto code = finding_code(*text)) return code;
  std::vector<std::string_view> ids;
  for (const auto& type : finding_catalogue()) {
    ids.push_back(type.id);
    if (type.name == *text) {
      mistakes.add(node, "write the code " + std::string(type.id) + " for " + *text);
      return std::nullopt;
    }
  }
  mistakes.add_unknown(node, "finding", *text, ids);
  return std::nullopt;
}

bool ProfileReader::knows(const std::string& name) const {
  return (profiles_.IsMap() && profiles_[name].IsDefined()) || find_builtin(name) != nullptr;
}

std::vector<std::string_view> ProfileReader::names() const {
  std::vector<std::string_view> names;
  if (profiles_.IsMap()) {
    for (const auto& entry : profiles_) {
      if (entry.first.IsScalar()) names.push_back(entry.first.Scalar());
    }
  }
  for (const auto& builtin : builtin_profiles()) names.push_back(builtin.name);
  return names;
}

void ProfileReader::read_all() {
  if (!profiles_.IsDefined() || profiles_.IsNull()) return;
  read_entries(profiles_, mistakes_,
               [&](const std::string& name, const YAML::Node&, const YAML::Node&) {
                 static_cast<void>(profile(name));
               });
}

Profile ProfileReader::resolved(const std::string& name, std::vector<std::string> through) {
  const bool is_own = profiles_.IsMap() && profiles_[name].IsDefined();
  // A profile of the file may have the name of a built-in one and extend that.
  const bool is_seen = std::find(through.begin(), through.end(), name) != through.end();
  YAML::Node node;
  if (is_own && !is_seen) {
    node = profiles_[name];
  } else if (const auto* builtin = find_builtin(name)) {
    node = YAML::Load(std::string(builtin->yaml));
  } else {
    mistakes_.add(profiles_[name], "the profile " + text::quoted(name) + " extends itself");
    return {};
  }
  if (node.IsNull()) return {};
  through.push_back(name);
  Profile profile = base_of(node, std::move(through));
  profile.name = name;
  auto keys = setting_keys(profile);
  keys.push_back({"extends", [](const YAML::Node&) {}});
  read_keys(node, mistakes_, keys);
  return profile;
}

Profile ProfileReader::base_of(const YAML::Node& node, std::vector<std::string> through) {
  if (!node.IsMap() || !node["extends"].IsDefined()) return {};
  const auto name = yaml_text(node["extends"], mistakes_);
  if (!name) return {};
  if (knows(*name)) return resolved(*name, std::move(through));
  mistakes_.add_unknown(node["extends"], "profile", *name, names());
  return {};
}

std::vector<YamlKey> ProfileReader::setting_keys(Profile& profile) {
  return {{"severity", [this, &profile](const YAML::Node& n) { read_severity(n, profile); }},
          {"checks", [this, &profile](const YAML::Node& n) { read_checks(n, profile); }},
          {"robot", [this, &profile](const YAML::Node& n) { read_robot(n, profile); }}};
}

std::optional<Level> ProfileReader::level(const YAML::Node& node) {
  const auto text = yaml_text(node, mistakes_);
  if (!text) return std::nullopt;
  const auto level = parse_level(*text);
  if (!level) {
    mistakes_.add_unknown(node, "severity", *text, {"off", "note", "warning", "error"});
  }
  return level;
}

void ProfileReader::read_severity(const YAML::Node& node, Profile& profile) {
  const auto set = [&](Severity severity) {
    return [this, &profile, severity](const YAML::Node& value) {
      if (const auto to = level(value)) {
        profile.by_severity[static_cast<std::size_t>(severity)] = *to;
      }
    };
  };
  read_keys(node, mistakes_,
            {{"note", set(Severity::kNote)},
             {"warning", set(Severity::kWarning)},
             {"error", set(Severity::kError)}});
}

void ProfileReader::read_checks(const YAML::Node& node, Profile& profile) {
  read_entries(node, mistakes_,
               [&](const std::string&, const YAML::Node& key, const YAML::Node& value) {
                 if (const auto code = yaml_code(key, mistakes_)) read_check(*code, value, profile);
               });
}

void ProfileReader::read_check(FindingCode code, const YAML::Node& node, Profile& profile) {
  const auto read_level = [&](const YAML::Node& value) {
    if (const auto to = level(value)) profile.levels[code] = *to;
  };
  if (!node.IsMap()) return read_level(node);
  auto keys = parameter_keys(code, profile, mistakes_);
  keys.push_back({"severity", read_level});
  read_keys(node, mistakes_, keys);
}

void ProfileReader::read_robot(const YAML::Node& node, Profile& profile) {
  std::vector<YamlKey> keys;
#define MAPWRIGHT_PARAMETER(code, key, member, least, most)
#define MAPWRIGHT_ROBOT_PARAMETER(key, member, least, most)                      \
  keys.push_back({#key, [&](const YAML::Node& value) {                           \
                    profile.member = yaml_number(value, least, most, mistakes_); \
                  }});
#include "validators/profile/parameters.def"
#undef MAPWRIGHT_ROBOT_PARAMETER
#undef MAPWRIGHT_PARAMETER
  read_keys(node, mistakes_, keys);
}

}  // namespace mapwright::validators
