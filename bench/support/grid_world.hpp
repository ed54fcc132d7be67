// Grid maps with published path lengths (movingai.com benchmarks).
#pragma once

#include <istream>
#include <vector>

#include "bench/support/polygonal_world.hpp"
#include "mapcore/map.hpp"

namespace mapwright::bench {

/// Map of a grid in the format "type octile": cells of one metre, each row's runs of blocked cells
/// (all but '.', 'G' and 'S') as boxes, the first row at y in [0, 1]. Throws std::runtime_error for
/// another format.
Map read_grid_world(std::istream& map);

/// Scenario lines "version 1": start and goal are the middles of cells; the length is the shortest
/// over straight and diagonal steps that cut no corner of a blocked cell.
std::vector<PublishedQuery> read_scenarios(std::istream& scenarios);

}  // namespace mapwright::bench
