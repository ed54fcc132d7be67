#include "cli/check/run_settings.hpp"

#include <set>
#include <stdexcept>
#include <vector>

#include "cli/support/digest.hpp"
#include "cli/support/files.hpp"
#include "cli/version.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

// Options that change nothing in what is said of a map that is checked to its end; and config and
// today, whose effect is in policies_digest.
const std::set<std::string> kOutside{"map",     "recursive", "jobs",   "shard",         "format",
                                     "output",  "journal",   "resume", "help",          "quiet",
                                     "verbose", "config",    "today",  "write-baseline"};
const std::set<std::string> kLimits{"time-limit", "memory-limit"};

// The configuration has a say in these unless they stand on the command line (with_profile).
const std::set<std::string> kProfiled{"robot-radius", "laser-height", "max-range",
                                      "min-unreachable", "min-converged"};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string value_text(const std::string& name, const boost::any& value) {
  if (const auto* text = boost::any_cast<std::string>(&value)) return *text;
  if (const auto* flag = boost::any_cast<bool>(&value)) return *flag ? "yes" : "no";
  if (const auto* words = boost::any_cast<std::vector<std::string>>(&value)) return joined(*words);
  throw std::logic_error("option " + name + " has a type that run_settings does not know");
}

std::string setting(const std::string& name, const po::variable_value& value) {
  const std::string text = value_text(name, value.value());
  if (name == "baseline") return text + " " + digest({read_file(text)});
  const bool yields = value.defaulted() && kProfiled.count(name) > 0;
  return yields ? text + " unless configured" : text;
}

}  // namespace

std::string RunSettings::fingerprint() const {
  std::vector<std::string_view> pieces{program};
  for (const auto& [name, value] : options) {
    pieces.push_back(name);
    pieces.push_back(value);
  }
  return digest(pieces);
}

RunSettings run_settings(const po::variables_map& values) {
  RunSettings settings{kVersion, {}, {}};
  for (const auto& [name, value] : values) {
    if (value.empty() || kOutside.count(name) > 0) continue;
    auto& settings_of_kind = kLimits.count(name) > 0 ? settings.limits : settings.options;
    settings_of_kind[name] = setting(name, value);
  }
  return settings;
}

}  // namespace mapwright::cli
