// How the verb plan answers.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cli/plan/solver.hpp"

namespace mapwright::cli {

/// JSON by docs/cli.md, "schema": "mapwright.plan/1"; with the trees and the paths before smoothing
/// if asked.
void write_plan_json(std::ostream& out, const PlanSettings& settings,
                     const std::vector<PlanAnswer>& answers, bool with_tree);

/// A line of figures and the points of the path for each query.
void write_plan_text(std::ostream& out, const std::vector<PlanAnswer>& answers);

}  // namespace mapwright::cli
