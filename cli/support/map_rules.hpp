// By which rules each of many maps is judged.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/support/map_reports.hpp"
#include "cli/support/policy_options.hpp"
#include "cli/support/policy_reports.hpp"
#include "mapcore/text/document.hpp"
#include "validators/profile/judge.hpp"
#include "validators/report/report.hpp"

namespace mapwright::cli {

/// Configuration files and baseline of a run. All reading is done by the constructor; `profile` and
/// `judge` may be called from any thread or process, the rest is for the one that writes the
/// report.
class MapRules {
 public:
  /// Finds the configuration of each map: the one that was named, or .mapwright.yaml beside the map
  /// or in a folder above, or none. Throws Error for files that cannot be read or understood.
  MapRules(const PolicyOptions& options, const std::vector<std::string>& maps);
  ~MapRules();

  const validators::Profile& profile(const std::string& map) const;

  /// Requires one of the maps. The findings are those of the document.
  validators::Judgement judge(const std::string& map, const MapDocument& document,
                              std::vector<Finding> findings) const;

  /// Takes note of what became of a map.
  void add(const validators::MapReport& report);

  /// What is wrong with the configuration files; refers to this object.
  /// `every_map_was_seen`: only then is it known which suppressions nobody needs.
  std::vector<validators::MapReport> policy_reports(bool every_map_was_seen) const;

  /// Writes the baseline, if one was asked for.
  void write_baseline() const;

  const Policies& policies() const { return policies_; }

  /// Success where findings went into a new baseline.
  ExitStatus status(const ReportTotals& totals) const;

 private:
  struct Rules;  ///< of one map
  const Rules& rules_of(const std::string& map) const;
  const validators::Policy& policy_of(const std::string& map);

  PolicyOptions options_;
  Policies policies_;
  std::map<std::string, Rules> rules_;  ///< by the map's path as reports show it
  std::optional<validators::Baseline> baseline_;
  validators::Baseline new_baseline_;
  std::set<std::string> used_;  ///< suppressions, by name
};

}  // namespace mapwright::cli
