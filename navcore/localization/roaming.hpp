// A simulated robot that drives about.
#pragma once

#include <optional>

#include "navcore/free_space.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// Area that a disc robot reaches from p, driving between places 0.5 m apart; stops counting at
/// `enough_m2`. Passages hardly wider than the disc may be missed; for a proof of what can be
/// reached see the exact planner. 0 where the disc does not fit at p.
double roaming_area_m2(const FreeSpace& space, Point p, double radius_m, double enough_m2);

/// A uniformly distributed place where the robot has room to drive: a map may hold pockets nobody
/// can enter or leave. Where no place with 200 m² around it turns up, the best of those that were
/// tried; nothing where the robot fits nowhere.
std::optional<Point> sample_roaming_place(const FreeSpace& space, double radius_m, Random& random);

/// The next movement of a robot that strolls through free space: about `distance_m` ahead, turning
/// a little at random, more where something is in the way, without touching anything. Where it
/// cannot drive that far in any direction it tries half of it, and so on; at last it turns on the
/// spot.
OdometryStep stroll(const FreeSpace& space, const Pose& pose, double distance_m, double radius_m,
                    Random& random);

}  // namespace mapwright::navcore
