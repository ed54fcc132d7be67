#include "cli/support/policy_options.hpp"

#include <chrono>

#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

validators::Date current_day() {
  return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
}

std::string text_of(const po::variables_map& values, const char* name) {
  return values.count(name) > 0 ? values[name].as<std::string>() : std::string();
}

}  // namespace

void declare_config_options(po::options_description& options) {
  auto add = options.add_options();
  add("config", po::value<std::string>(),
      "a configuration file: severities, limits, suppressions; without it .mapwright.yaml, looked "
      "for beside each map and in the folders above");
  add("no-config", po::bool_switch(), "look for no configuration file");
  add("profile", po::value<std::string>(),
      "of the configuration, or one of default, report, strict, authoring");
  add("today", po::value<std::string>(),
      "YYYY-MM-DD: the day on which suppressions have expired or not; without it this day");
}

void declare_policy_options(po::options_description& options) {
  declare_config_options(options);
  auto add = options.add_options();
  add("baseline", po::value<std::string>(),
      "findings of an earlier run: they are known, and only others count");
  add("write-baseline", po::value<std::string>(),
      "write what is found now as a baseline; then the exit status is 0 whatever is found");
}

PolicyOptions policy_options(const po::variables_map& values) {
  PolicyOptions options;
  options.config = text_of(values, "config");
  options.no_config = values["no-config"].as<bool>();
  options.profile = text_of(values, "profile");
  options.baseline = text_of(values, "baseline");
  options.write_baseline = text_of(values, "write-baseline");
  if (options.no_config && !options.config.empty()) {
    fail_usage("--config and --no-config exclude each other");
  }
  const std::string today = text_of(values, "today");
  const auto day = today.empty() ? current_day() : validators::parse_date(today);
  if (!day) fail_usage("--today: '" + today + "' is no day; write it as 2027-01-31");
  options.today = *day;
  return options;
}

}  // namespace mapwright::cli
