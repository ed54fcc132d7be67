// What the edges of things tell where their faces do not.
#pragma once

#include <span>

#include "navcore/localizability/beam_noise.hpp"
#include "navcore/localizability/scan_information.hpp"

namespace mapwright::navcore {

/// Where the range jumps from one beam to the next, something ends between the two: its edge is
/// seen within one step δ between beams, which is worth the variance δ²/12 of its bearing.
///
/// Not Fisher information: a range that jumps has no derivative, and within the step the position
/// is open. It says what a robot that knows its rough place, as a filter does, gets out of a scan
/// beyond the bound that Fisher information gives for estimators without any bias. Requires a scan
/// of `laser` from `pose`.
PoseInformation edge_information(std::span<const RangeGradient> scan, const Pose& pose,
                                 const LaserModel& laser, const BeamNoise& noise);

}  // namespace mapwright::navcore
