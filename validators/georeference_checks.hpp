// Whether a map and its georeference sidecar fit each other.
#pragma once

#include <optional>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/map.hpp"

namespace mapwright::validators {

/// What can be said without a library of coordinate systems: C240 (no sidecar), C242 and C243. In
/// that order; without line and column, since they stand in no map text.
std::vector<Finding> check_georeference(const Map& map,
                                        const std::optional<Georeference>& georeference);

}  // namespace mapwright::validators
