// Private to this folder: segments seen edge-on, in double precision.
#pragma once

#include <cstdint>

#include "mapcore/angle.hpp"
#include "navcore/engine/beam_table.hpp"
#include "navcore/engine/scene.hpp"

namespace mapwright::navcore::engine {

/// Distance along the ray u (unit vector, from the origin) to the closed segment ab; infinity where
/// it misses. A ray along the segment's line is stopped at its nearest point. Sides of the ends are
/// the same products for both segments that share an end, so that no ray slips between them.
double distance_to_segment(Point u, Point a, Point b);

/// The same for a segment that stops only rays from its left that do not run along it.
double distance_to_one_sided(Point u, Point a, Point b);

/// Raises `inverse_ranges` (1/m, one for each ray) to what the scene's item (a segment, or a ramp
/// at laser height `height_m`) gives. For the few segments whose line passes within millimetres of
/// the laser, where single precision would not do.
void cast_at_item(const Scene& scene, std::uint32_t item, double height_m, const BeamTable& beams,
                  const Pose& pose, float* inverse_ranges);

}  // namespace mapwright::navcore::engine
