// Where the chain of an obstacle's segments branches.
#pragma once

#include <cstddef>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// True if the segment at position k > 0 is the one before it again.
bool repeats_the_one_before(const Obstacle& obstacle, std::size_t k);

/// Per segment: true if it does not join the one before it but begins where two others meet, so
/// that the chain branches there. n log n.
std::vector<bool> branches_of(const Obstacle& obstacle);

}  // namespace mapwright::validators
