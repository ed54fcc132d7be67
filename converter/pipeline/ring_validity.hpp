// Whether the rings of a polygon are fit to be written.
#pragma once

#include <string>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// What is wrong with a polygon's rings (the outer one first), in words; empty where every ring is
/// simple, holes lie in the outer ring and not in each other, and no two rings cross or overlap
/// (touching at single points is sound).
std::string polygon_defect(const std::vector<std::vector<Point>>& rings);

}  // namespace mapwright::converter
