// Private to this folder: one ray at a time, in double precision.
#pragma once

#include "mapcore/point.hpp"
#include "navcore/engine/scene.hpp"

namespace mapwright::navcore::engine {

/// Range of the ray from `origin` along the unit vector `direction`, `max_range_m` where nothing
/// stops it. Walks through the scene's bins and stops at the first bin that ends beyond the nearest
/// hit.
double cast_ray(const Scene& scene, Point origin, Point direction, double height_m,
                double max_range_m);

}  // namespace mapwright::navcore::engine
