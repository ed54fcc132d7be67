// Shortest paths the slow way: every pair of corners, every wall.
#pragma once

#include <optional>
#include <vector>

#include "navcore/free_space.hpp"

namespace mapwright::test {

/// Length of a shortest path for a point in closed free space, by a visibility graph and Dijkstra;
/// nothing where there is none. Shares no code with the exact planner but FreeSpace's answer to
/// what is solid. For maps with small coordinates on a coarse grid (it compares with 1e-7 m).
///
/// A path that touches walls keeps track of the side on which it passes them: a state of the search
/// is a corner and the sector between two walls there.
std::optional<double> slow_shortest_length_m(const Map& map, Point start, Point goal);

}  // namespace mapwright::test
