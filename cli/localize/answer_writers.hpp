// Answers of the verb localize.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "navcore/localization/experiment.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::cli {

/// What an answer repeats of the question.
struct LocalizeQuestion {
  std::string likelihood;  ///< "robust" or "report"
  navcore::ExperimentSettings settings;
  std::uint64_t seed = 1;
};

void write_run_json(std::ostream& out, const LocalizeQuestion& question,
                    const navcore::ExperimentRun& run);
void write_run_text(std::ostream& out, const navcore::ExperimentRun& run);

void write_trials_json(std::ostream& out, const LocalizeQuestion& question,
                       const std::vector<navcore::ExperimentRun>& runs,
                       const navcore::TrialSummary& summary);
void write_trials_text(std::ostream& out, const navcore::TrialSummary& summary);

}  // namespace mapwright::cli
