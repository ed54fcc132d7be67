// Private to this folder: Free space for a disc.
#pragma once

#include "navcore/exact/tessellation.hpp"

namespace mapwright::navcore::exact {

/// How closely the free space of a disc is followed.
struct OffsetOptions {
  double radius_mm = 0.0;       ///< of the disc, > 0
  int tangents_a_quadrant = 2;  ///< sides that stand for a quarter of a circle, >= 1
  double base_error_mm = 0.0;   ///< how far the base may lie from the map
};

/// The factor by which the way around a convex corner is wider than the circle: 1 / cos of half the
/// angle between two tangents.
double offset_excess(int tangents_a_quadrant);

/// Where the centre of a disc can be, given where a point can be.
///
/// The walls are moved into the free space by the radius; around convex corners the circle is
/// replaced by tangents outside of it. What results lies within the true free space of the disc:
/// every point of it keeps `radius_mm` from the map. It lacks at most a rim of
/// radius · (offset_excess − 1) at convex corners, and 1.5 mm + base_error_mm everywhere, which
/// pays for rounding to the grid.
///
/// Empty for a disc wider than the base, and for one of more than 100 km, which counts as such.
///
/// `Line::source` of the result's lines is the edge of `base` they keep away from.
Tessellation offset_free_space(const Tessellation& base, const OffsetOptions& options);

}  // namespace mapwright::navcore::exact
