// Private to this folder: where a ramp stands as high as the laser.
#pragma once

#include <vector>

#include "navcore/engine/scene.hpp"

namespace mapwright::navcore::engine {

/// A wall without height of its own that stops only rays coming from its left.
struct OneSidedSegment {
  Point a, b;
};

/// The pieces of the ramp's contour at `height_m` that lie in its closed footprint, with the low
/// side on the left of a→b: a level ray at that height runs into the ramp there and nowhere else
/// (docs/rays.md). Double precision.
std::vector<OneSidedSegment> iso_lines(const SceneRamp& ramp, double height_m);

}  // namespace mapwright::navcore::engine
