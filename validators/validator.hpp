// Whether a map is fit for a robot: runs every check of checks.def.
#pragma once

#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::validators {

/// Limits of the checks. The defaults suit a wheeled robot on a campus.
struct ValidationOptions {
  double max_coordinate_m = tolerance::kAbsurdCoordinate_m;     ///< G102
  double overlap_depth_m = tolerance::kOverlapDepth_m;          ///< G108: less is touching
  double max_height_m = tolerance::kAbsurdHeight_m;             ///< S107
  double min_step_rise_m = tolerance::kLeastStepRise_m;         ///< T104
  double max_step_rise_m = tolerance::kGreatestStepRise_m;      ///< T104
  double max_step_turn_deg = tolerance::kGreatestStepTurn_deg;  ///< T105: from step to step
  double unit_normal_error = tolerance::kUnitLength;            ///< T202: | length − 1 |
  double max_ramp_slope_deg = tolerance::kSteepRamp_deg;        ///< T204
};

/// Everything that is wrong with a map: what its reader found (family F) and what every check finds
/// (families G, S and T), in the order of `sort_findings`.
///
/// n log n in the number of segments plus the number of pairs of obstacles whose boxes meet; more
/// only for large outlines that cross themselves (docs/checks/G104.md).
/// Deterministic.
std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options = {});

}  // namespace mapwright::validators
