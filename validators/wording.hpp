// How findings name things and write numbers.
#pragma once

#include <cstddef>
#include <string>

#include "mapcore/finding.hpp"
#include "mapcore/map.hpp"

namespace mapwright::validators {

/// "obstacle 26".
std::string name_of(const Obstacle& obstacle);

/// "segment 3 of obstacle 26"; `segment` counts from 0.
std::string name_of(const Obstacle& obstacle, std::size_t segment);

/// Metres with up to three decimals, no trailing zeros; two significant digits for what is smaller
/// than a millimetre.
std::string metres(double value);

/// "from layer buildings, feature 12 of campus.gpkg": where the obstacle came from; of many
/// features the first three. Empty where nothing is known.
std::string origin_text(const Finding& finding);

/// The message with the origin behind it.
std::string message_text(const Finding& finding);

/// "(34.65, 41.02)".
std::string place_text(Point p);

}  // namespace mapwright::validators
