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

// Options that change nothing in what is said of a map that is checked to its end.
const std::set<std::string> kOutside{"map",     "recursive", "jobs", "shard", "format", "output",
                                     "journal", "resume",    "help", "quiet", "verbose"};
const std::set<std::string> kLimits{"time-limit", "memory-limit"};
const std::set<std::string> kFiles{"profile", "baseline"};

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
    const std::string text = value_text(name, value.value());
    if (kLimits.count(name) > 0) {
      settings.limits[name] = text;
    } else {
      settings.options[name] = kFiles.count(name) > 0 ? digest({read_file(text)}) : text;
    }
  }
  return settings;
}

}  // namespace mapwright::cli
