// Private to this folder: What a part of the medial axis runs between.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "navcore/exact/voronoi_graph.hpp"

namespace mapwright::navcore::exact {

/// Sites in the order in which a closed curve around a part of the medial axis passes them. Each
/// shares an end with the next, or has an edge of the medial axis in common with it that is not
/// open.
using SiteRound = std::vector<VoronoiSite>;

/// The part is what hangs together with `vertex` by open edges: one round for each curve that
/// bounds it. Vertices and edges are those of build_voronoi_graph(space), whose diagram is made
/// once more, this time with its edges' order around vertices.
std::vector<SiteRound> rounds_around(const Tessellation& space, std::uint32_t vertex,
                                     const std::function<bool(std::uint32_t)>& is_open);

}  // namespace mapwright::navcore::exact
