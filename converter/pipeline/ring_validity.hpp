// Whether the rings of a polygon are fit to be written.
#pragma once

#include <string>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// What is wrong with a polygon's rings (the outer one first), in words; empty where every ring is
/// simple, holes lie in the outer ring and not in each other, no two rings cross or overlap
/// (touching at single points is sound), and holes do not cut the inside into pieces.
std::string polygon_defect(const std::vector<std::vector<Point>>& rings);

/// What is wrong between the polygons of one feature (each a list of rings, the outer one first),
/// each sound in itself; empty where they touch at single points at most.
std::string parts_defect(const std::vector<std::vector<std::vector<Point>>>& polygons);

}  // namespace mapwright::converter
