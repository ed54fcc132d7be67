// Checking a barrier against the map itself.
#pragma once

#include <span>

#include "navcore/exact/exact_planner.hpp"

namespace mapwright::navcore {

/// True if the barrier proves that a disc (0: a point) cannot travel from start to goal: it is
/// closed, runs along the map's own blocking segments and border and across gaps too narrow, and
/// winds around start and goal differently. Decided with integers by exact/barrier.hpp on the map's
/// segments rounded to millimetres; nothing that found the barrier is trusted. A start or goal of a
/// point robot may lie on an outline: then all free sectors between the lines there count. False
/// also for a map no planner can be built for, and for a point robot where walls that cross off the
/// grid were moved.
bool proves_unreachable(const Map& map, RampPolicy ramps, std::span<const BarrierSide> barrier,
                        Point start, Point goal, double radius_m);

}  // namespace mapwright::navcore
