// Answers of `mapwright localize --log --kidnap`.
#pragma once

#include <iosfwd>
#include <vector>

#include "cli/localize/recorded_question.hpp"
#include "navcore/localization/kidnapping.hpp"

namespace mapwright::cli {

struct KidnappedRun {
  ScanStretch before, after;
  navcore::KidnappingVerdict verdict;
};

void write_kidnapped_text(std::ostream& out, const std::vector<KidnappedRun>& runs);
void write_kidnapped_json(std::ostream& out, const RecordedQuestion& question,
                          const std::vector<KidnappedRun>& runs);

}  // namespace mapwright::cli
