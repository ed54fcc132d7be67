// A laser that overlooks the whole map.
#pragma once

#include "cli/support/console.hpp"
#include "mapcore/map.hpp"

namespace mapwright::cli {

/// Warns if nothing on the map is higher than the laser (metres above the ground): no ray would
/// meet anything, and whatever is computed from scans says nothing.
void warn_of_blind_laser(const Map& map, double laser_height_m, Console& console);

}  // namespace mapwright::cli
