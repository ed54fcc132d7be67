// Layers that are storeys of one building by their names and places.
#pragma once

#include <optional>
#include <string>

#include "converter/pipeline/sources.hpp"

namespace mapwright::converter {

/// True where boxes have an area in common.
bool overlap(const Box& p, const Box& q);

/// True for names that differ in one word, which is a storey's in both: "site_1_walls" and
/// "site_B1_walls", "EG" and "OG2".
bool are_names_of_storeys(const std::string& p, const std::string& q);

/// A warning where layers that are converted are storeys above each other, which a map has one on
/// top of the other; nothing where none are. Asks layers with such names for their extents.
std::optional<std::string> warning_of_storeys(const OpenedSources& sources);

}  // namespace mapwright::converter
