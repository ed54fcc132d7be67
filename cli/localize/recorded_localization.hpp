// Runs what `mapwright localize --log` asks for.
#pragma once

#include "cli/localize/recorded_question.hpp"
#include "cli/support/console.hpp"
#include "cli/support/ray_engine.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {

struct RecordedOutput {
  bool json = false;
  unsigned threads = 0;  ///< stretches are spread over them
  double required_percent = 50.0;
};

/// Writes the answer. kNegative if the run did not converge, or fewer of the stretches than
/// required.
ExitStatus localize_recorded(const Map& map, RayEngineKind engine, const RecordedQuestion& question,
                             const RecordedOutput& output, Console& console);

}  // namespace mapwright::cli
