// What is known of a place before a scan.
#pragma once

#include <optional>
#include <variant>

#include "navcore/free_space.hpp"
#include "navcore/localization/heading_prior.hpp"
#include "navcore/localization/moved_poses.hpp"
#include "navcore/localization/place_cells.hpp"

namespace mapwright::navcore {

/// The robot may be anywhere in free space: this is the part of it within one cell.
struct FlatPrior {
  PlaceCell cell;
  const FreeSpace* space = nullptr;
  double log_density_m2 = 0.0;  ///< logarithm of the probability a m²
  std::optional<HeadingPrior> heading;
};

/// The robot has been tracked to here with a probability of exp(log_share). Where the map
/// blocks its way (`space`, for a disc), that is exp(log_through_barrier) times as likely.
struct TrackedPrior {
  MovedPoses poses;
  double log_share = 0.0;
  const FreeSpace* space = nullptr;
  double robot_radius_m = 0.0;
  double log_through_barrier = 0.0;
};

/// Whether a disc can move from one point to the other.
bool is_way(const FreeSpace& space, Point from, Point to, double radius_m);

using PlacePrior = std::variant<FlatPrior, TrackedPrior>;

/// Logarithm of the probability a m² a radian; −∞ outside of a flat prior's cell or in a solid.
/// Whether the way there is free is another question.
double log_density(const PlacePrior& prior, const Pose& pose);

/// Logarithm of what is left of that because of the way there: 0 where nothing blocks it.
double log_way(const PlacePrior& prior, const Pose& pose);

}  // namespace mapwright::navcore
