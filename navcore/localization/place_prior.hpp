// What is known of a place before a scan.
#pragma once

#include <optional>
#include <variant>

#include "navcore/free_space.hpp"
#include "navcore/localization/heading_prior.hpp"
#include "navcore/localization/place_cells.hpp"
#include "navcore/localization/pose_belief.hpp"

namespace mapwright::navcore {

/// The robot may be anywhere in free space: this is the part of it within one cell.
struct FlatPrior {
  PlaceCell cell;
  const FreeSpace* space = nullptr;
  double log_density_m2 = 0.0;  ///< logarithm of the probability a m²
  std::optional<HeadingPrior> heading;
};

/// The robot has been tracked to here with a probability of exp(log_share).
struct TrackedPrior {
  PoseBelief belief;
  double log_share = 0.0;
};

using PlacePrior = std::variant<FlatPrior, TrackedPrior>;

/// Logarithm of the probability a m² a radian; −∞ outside of a flat prior's cell or in a solid.
double log_density(const PlacePrior& prior, const Pose& pose);

}  // namespace mapwright::navcore
