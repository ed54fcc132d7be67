// Answers of `mapwright localize --log`.
#pragma once

#include <iosfwd>
#include <optional>
#include <vector>

#include "cli/localize/recorded_question.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::cli {

/// A run and, where the log has a reference, what came of it.
struct JudgedRun {
  navcore::RecordedRun run;
  std::optional<navcore::RecordedVerdict> verdict;

  /// Strictly localized by the reference; without one, by the filter's own belief at the end.
  bool converged() const;
};

/// Many runs together.
struct RecordedSummary {
  std::size_t runs = 0, strict = 0, strict_from_start = 0;
  std::optional<navcore::MedianAndP95> way_m;             ///< of the strict runs
  std::optional<navcore::MedianAndP95> position_error_m;  ///< of their scans once right
  std::size_t believed = 0, rightly_believed = 0;         ///< scans of all runs
};

RecordedSummary summarize(const std::vector<JudgedRun>& runs);

void write_recorded_run_json(std::ostream& out, const RecordedQuestion& question,
                             const JudgedRun& run);
void write_recorded_run_text(std::ostream& out, const JudgedRun& run);

void write_recorded_batch_json(std::ostream& out, const RecordedQuestion& question,
                               const std::vector<JudgedRun>& runs);
void write_recorded_batch_text(std::ostream& out, const std::vector<JudgedRun>& runs);

/// Processor time a scan, against the time that passed in the log; not for the answer, which is the
/// same on every machine.
std::string speed_text(const std::vector<JudgedRun>& runs);

}  // namespace mapwright::cli
