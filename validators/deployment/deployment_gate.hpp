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
  double min_unreachable_m2 = 1.0;  ///< N102: smaller pockets are not worth a finding
  double min_converged = 0.8;       ///< N104: share of localization runs, in [0, 1]
};

struct GateOutcome {
  std::vector<Finding> findings;  ///< of validation, then of navigation (N101 to N104)
  /// Absent where the border cannot be used: there is no map to navigate in then.
  std::optional<navcore::DeploymentOutcome> deployment;

  bool passes() const { return !has_errors(findings); }
};

/// Runs all checks, then the robot. Deterministic for any number of threads.
GateOutcome check_deployment(const MapDocument& document, const GateOptions& options);

/// Findings N101 to N104.
std::vector<Finding> deployment_findings(const navcore::DeploymentOutcome& outcome,
                                         const GateOptions& options);

/// "localization", "planning" and "reachability" of a report (docs/cli.md), null where not run, and
/// the verdict in words.
std::vector<ReportSection> deployment_sections(const GateOutcome& outcome,
                                               const GateOptions& options);

}  // namespace mapwright::validators
