// How finely a map is written.
#pragma once

#include "mapcore/map.hpp"

namespace mapwright {

/// The coarsest resolution, a power of ten of at most 1 mm and at least 1e-9, that all numbers of
/// the map are multiples of; 1e-9 where none is. Written at it, a map keeps all its decimals.
double resolution_of(const Map& map);

}  // namespace mapwright
