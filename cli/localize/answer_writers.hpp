// Answers of the verb localize.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "navcore/localization/experiment.hpp"
#include "navcore/localization/sequential_bound.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::cli {

/// What an answer repeats of the question.
struct LocalizeQuestion {
  std::string likelihood;  ///< "robust" or "report"
  navcore::ExperimentSettings settings;
  std::uint64_t seed = 1;
};

/// `bounds`: of the run's iterations.
void write_run_json(std::ostream& out, const LocalizeQuestion& question,
                    const navcore::ExperimentRun& run,
                    const std::vector<navcore::AccuracyBound>& bounds);
void write_run_text(std::ostream& out, const navcore::ExperimentRun& run,
                    const std::vector<navcore::AccuracyBound>& bounds);

/// What trials came to.
struct TrialsAnswer {
  navcore::TrialSummary summary;
  std::optional<navcore::BoundSummary> tracking;  ///< of runs that start from a known pose
};

void write_trials_json(std::ostream& out, const LocalizeQuestion& question,
                       const std::vector<navcore::ExperimentRun>& runs, const TrialsAnswer& answer);
void write_trials_text(std::ostream& out, const std::vector<navcore::ExperimentRun>& runs,
                       const TrialsAnswer& answer);

}  // namespace mapwright::cli
