// The gate before a map goes to a robot: is it well-formed, and does a robot get along on it?
#pragma once

#include <optional>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"
#include "navcore/deployment/deployment.hpp"
#include "validators/report/report.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

struct GateOptions {
  ValidationOptions validation;
  navcore::DeploymentSettings deployment;
  double min_unreachable_m2 = 1.0;  ///< N102, N106: smaller pockets are not worth a finding
  double min_converged = 0.8;       ///< N104: share of localization runs, in [0, 1]
};

struct GateOutcome {
  std::vector<Finding> findings;  ///< of validation, then of navigation (N101 to N108)
  /// Absent where the border cannot be used: there is no map to navigate in then. With a failure
  /// where the map is beyond what can be computed (an obstacle 500 km away).
  std::optional<navcore::DeploymentOutcome> deployment;
  std::vector<std::int64_t> obstacle_ids;  ///< by position in Map::obstacles, for reports

  bool passes() const { return !has_errors(findings); }
};

/// Runs all checks, then the robot. Deterministic for any number of threads.
GateOutcome check_deployment(const MapDocument& document, const GateOptions& options);

/// Findings N101 to N108. Where a gap is to blame, the message names both obstacles that make it,
/// and the finding has the place in the text of the first. `document` is what was run.
std::vector<Finding> deployment_findings(const MapDocument& document,
                                         const navcore::DeploymentOutcome& outcome,
                                         const GateOptions& options);

/// "localization", "localizability" (where asked for), "planning" and "reachability" of a report (docs/cli.md), null where not run, and
/// the verdict in words.
std::vector<ReportSection> deployment_sections(const GateOutcome& outcome,
                                               const GateOptions& options);

}  // namespace mapwright::validators
