#include "cli/support/map_rules.hpp"

#include <filesystem>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"

namespace mapwright::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConfigName = ".mapwright.yaml";

fs::path absolute_path(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::absolute(path, error).lexically_normal();
  return error ? path : result;
}

// "sub/map.txt" for a map below `folder`; with "../" for one beside it.
std::string seen_from(const fs::path& folder, const std::string& map) {
  if (map == "-") return map;
  return absolute_path(map).lexically_relative(absolute_path(folder)).generic_string();
}

fs::path folder_of(const std::string& file) {
  return absolute_path(file).parent_path();
}

// A file below the working folder is named from there.
std::string shown(const fs::path& file) {
  std::error_code error;
  const std::string relative = file.lexically_relative(fs::current_path(error)).string();
  return error || relative.empty() || relative.starts_with("..") ? file.string() : relative;
}

// The nearest configuration file in the map's folder or above; empty where there is none.
std::string find_config(const std::string& map) {
  std::error_code error;
  fs::path folder = map == "-" ? fs::current_path(error) : folder_of(map);
  while (!folder.empty()) {
    const fs::path candidate = folder / kConfigName;
    if (fs::is_regular_file(candidate, error)) return shown(candidate);
    if (folder == folder.parent_path()) break;
    folder = folder.parent_path();
  }
  return {};
}

validators::Baseline read_baseline(const std::string& path) {
  auto baseline = validators::Baseline::parse(read_file(path));
  if (!baseline) throw Error(ExitStatus::kInput, path + ": " + baseline.error().message);
  return *std::move(baseline);
}

std::vector<validators::KnownFinding> known_findings(const validators::MapReport& report,
                                                     const std::string& old_baseline) {
  std::vector<validators::KnownFinding> known;
  for (std::size_t i = 0; i < report.names.size(); ++i) {
    const auto& finding = report.findings[i];
    known.push_back({finding.code, report.names[i], finding.message});
  }
  for (const auto& suppressed : report.suppressed) {
    if (suppressed.by != old_baseline) continue;
    known.push_back({suppressed.finding.code, suppressed.name, suppressed.finding.message});
  }
  return known;
}

}  // namespace

struct MapRules::Rules {
  const validators::Policy* policy;
  std::string path_from_config;
  std::string path_from_baseline;
  std::string path_from_new_baseline;
};

MapRules::MapRules(const PolicyOptions& options, const std::vector<std::string>& maps)
    : options_(options) {
  if (!options_.baseline.empty()) baseline_ = read_baseline(options_.baseline);
  for (const auto& map : maps) {
    Rules rules{&policy_of(map), {}, {}, {}};
    rules.path_from_config = seen_from(folder_of(rules.policy->path), map);
    rules.path_from_baseline = seen_from(folder_of(options_.baseline), map);
    rules.path_from_new_baseline = seen_from(folder_of(options_.write_baseline), map);
    rules_.emplace(std::string(display_path(map)), std::move(rules));
  }
}

MapRules::~MapRules() = default;

const validators::Policy& MapRules::policy_of(const std::string& map) {
  std::string path = options_.config;
  if (path.empty() && !options_.no_config) path = find_config(map);
  const auto known = policies_.find(path);
  if (known != policies_.end()) return known->second;
  auto policy =
      validators::read_policy(path.empty() ? "" : read_file(path), path, options_.profile);
  if (!policy && policy.error().kind == FailureKind::kUsage) {
    fail_usage("--profile: " + policy.error().message);
  }
  return policies_.emplace(path, value_or_throw(std::move(policy))).first->second;
}

const MapRules::Rules& MapRules::rules_of(const std::string& map) const {
  return rules_.at(std::string(display_path(map)));
}

const validators::Profile& MapRules::profile(const std::string& map) const {
  return rules_of(map).policy->profile;
}

validators::Judgement MapRules::judge(const std::string& map, const MapDocument& document,
                                      std::vector<Finding> findings) const {
  const Rules& rules = rules_of(map);
  validators::JudgeContext context{document, *rules.policy, options_.today, rules.path_from_config};
  if (baseline_) {
    context.known = &baseline_->findings(rules.path_from_baseline);
    context.baseline_path = options_.baseline;
  }
  return validators::judge(std::move(findings), context);
}

void MapRules::add(const validators::MapReport& report) {
  for (const auto& suppressed : report.suppressed) used_.insert(suppressed.by);
  if (options_.write_baseline.empty() || report.unreadable) return;
  new_baseline_.add(rules_of(std::string(report.path)).path_from_new_baseline,
                    known_findings(report, options_.baseline));
}

std::vector<validators::MapReport> MapRules::policy_reports(bool every_map_was_seen) const {
  return cli::policy_reports(policies_, used_, every_map_was_seen, options_.today);
}

void MapRules::write_baseline() const {
  if (options_.write_baseline.empty()) return;
  write_file(options_.write_baseline, [&](std::ostream& out) { out << new_baseline_.text(); });
}

ExitStatus MapRules::status(const ReportTotals& totals) const {
  const auto status = totals.status();
  const bool all_is_known = !options_.write_baseline.empty() && totals.all_were_judged();
  return all_is_known ? ExitStatus::kSuccess : status;
}

}  // namespace mapwright::cli
