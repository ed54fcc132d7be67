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

  /// Reports what is wrong with the configuration files, a report a file, and writes the baseline.
  /// `every_map_was_seen`: only then is it known which suppressions nobody needs.
  void finish(validators::ReportWriter& writer, ReportTotals& totals, bool every_map_was_seen);

  /// Success where findings went into a new baseline.
  ExitStatus status(const ReportTotals& totals) const;

 private:
  struct Rules;  ///< of one map
  const Rules& rules_of(const std::string& map) const;
  const validators::Policy& policy_of(const std::string& map);
  void report_policy(const validators::Policy& policy, validators::ReportWriter& writer,
                     ReportTotals& totals, bool every_map_was_seen) const;

  PolicyOptions options_;
  std::map<std::string, validators::Policy> policies_;  ///< by the file's path; empty: none
  std::map<std::string, Rules> rules_;                  ///< by the map's path as reports show it
  std::optional<validators::Baseline> baseline_;
  validators::Baseline new_baseline_;
  std::set<std::string> used_;  ///< suppressions, by name
};

}  // namespace mapwright::cli
