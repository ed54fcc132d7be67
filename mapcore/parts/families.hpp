// Private to this folder: outlines and their holes.
#pragma once

#include <cstddef>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright {

/// For each obstacle the position of the outline that `inner_of` names; its own where there is
/// none.
std::vector<std::size_t> outline_of_each(const Map& map);

}  // namespace mapwright
