// What verbs that report on many maps share.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/support/console.hpp"
#include "cli/verb.hpp"
#include "mapcore/finding.hpp"
#include "mapcore/map.hpp"
#include "validators/report/report.hpp"

namespace mapwright::cli {

/// "text, json …": the report formats there are.
std::string report_format_names();

/// Throws Error (kUsage) for a name that is not among them.
const validators::ReportFormat& find_report_format(const std::string& name);

/// Throws Error (kUsage) where a format that is no text would go to standard output ("-").
void check_report_output(const validators::ReportFormat& format, const std::string& output);

/// True if the verb's results go to a terminal that shows colours (TERM is not "dumb", NO_COLOR is
/// not set, or empty).
bool is_colour_terminal(const Console& console);

/// The findings about the sidecar of a map, and about a map that should have one; none for standard
/// input. Throws Error (kInput) where the sidecar cannot be read.
std::vector<Finding> sidecar_findings(const std::string& map_path, const Map& map);

/// What the summary line and the exit status need to know of all maps.
class ReportTotals {
 public:
  void add(const validators::MapReport& report);

  /// The findings of a file that is no map.
  void add_findings(const std::vector<Finding>& findings);

  /// "3 maps: 2 fit, 1 not; 4 errors, 1 warning", and what was suppressed.
  std::string summary() const;

  /// kInternal where the check of a map crashed, kInput where a map could not be read, kNegative
  /// for errors found or limits exceeded, else kSuccess.
  ExitStatus status() const;

  /// True if no map was unreadable, over a limit or made the program crash.
  bool all_were_judged() const { return unreadable_ + over_limit_ + crashed_ == 0; }

 private:
  std::size_t& count_of(validators::Interruption interruption);

  std::size_t maps_ = 0, unreadable_ = 0, over_limit_ = 0, crashed_ = 0, failed_ = 0;
  std::size_t errors_ = 0, warnings_ = 0, notes_ = 0, suppressed_ = 0;
};

}  // namespace mapwright::cli
