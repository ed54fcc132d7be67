// Whether a map is fit for a robot: runs every check of checks.def.
#pragma once

#include <cstdint>
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

  double near_miss_m = tolerance::kSnap_m;                      ///< G120
  double spike_width_m = tolerance::kSliverWidth_m;             ///< G121
  double sliver_width_m = tolerance::kSliverWidth_m;            ///< G122
  double max_border_margin_m = tolerance::kBorderMargin_m;      ///< G125
  double min_border_margin_m = tolerance::kTightBorder_m;       ///< G126
  double suspect_height_m = tolerance::kSuspectHeight_m;        ///< S120
  double laser_height_m = tolerance::kLaserHeight_m;            ///< S121
  double ground_clearance_m = tolerance::kGroundClearance_m;    ///< S121
  double min_step_tread_m = tolerance::kLeastStepTread_m;       ///< T120
  double max_step_tread_m = tolerance::kGreatestStepTread_m;    ///< T120, T125
  double max_rise_variation_m = tolerance::kRiseVariation_m;    ///< T121
  double max_tread_variation_m = tolerance::kTreadVariation_m;  ///< T122
  double min_step_width_m = tolerance::kLeastStepWidth_m;       ///< T123
  double max_width_ratio = tolerance::kGreatestStepWidthRatio;  ///< T124
  double min_ramp_rise_m = tolerance::kLeastRampRise_m;         ///< T130
  double max_ramp_rise_m = tolerance::kGreatestRampRise_m;      ///< T130
};

/// Everything that is wrong with a map: what its reader found (family F) and what every check finds
/// (families G, S and T), in the order of `sort_findings`.
///
/// n log n in the number of segments plus the number of pairs of obstacles whose boxes meet; more
/// only for large outlines that cross themselves (docs/checks/G104.md).
/// Deterministic.
std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options = {});

/// Whether checks may pass over obstacles that are proven to be sound, which most are. What they
/// find is the same.
enum class Proofs : std::uint8_t { kAll, kNone };

/// The same without proofs: every check looks at every obstacle. Slow; for tests.
std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options,
                              Proofs proofs);

}  // namespace mapwright::validators
