// Predicted against seen: particle filters at places of a localizability field.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/progress.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localizability/localizability.hpp"

namespace mapwright::navcore {

struct ConfirmationSettings {
  std::size_t places = 100;
  std::size_t runs = 20;         ///< of the tracking filter, at each place
  std::size_t particles = 1000;  ///< of the tracking filter
  double start_sigma_m = 0.3;    ///< it believes its start to be known so well, in x and in y
  double start_sigma_deg = 3.0;
  std::size_t global_runs = 4;   ///< of the filter that starts anywhere, at each place
  std::size_t pair_tests = 200;  ///< of scans between a place and its twin
  std::uint64_t seed = 1;
};

/// Tracking with one scan from one pose: a bound that takes the start's belief for one more
/// measurement, and the errors seen, along the axes of the Cramér-Rao bound.
struct TrackedPlace {
  Pose pose;
  double bound_major_m = 0.0, bound_minor_m = 0.0;  ///< Cramér-Rao, with the start's belief
  double edges_major_m = 0.0, edges_minor_m = 0.0;  ///< the same with edges, along the same axes
  double seen_major_m = 0.0, seen_minor_m = 0.0;    ///< root mean square over the runs
  double bound_heading_rad = 0.0, seen_heading_rad = 0.0;
};

/// Places by their risk: what was predicted, and how often robots were wrong.
struct RiskClass {
  double from = 0.0, to = 0.0;  ///< of the risk, at least
  std::size_t places = 0;
  double predicted_least = 0.0, predicted_most = 0.0;  ///< mean bounds on the pairs' mistakes
  std::size_t pair_tests = 0, pair_mistakes = 0;  ///< the likelier of place and twin was the twin
  std::size_t global_runs = 0, global_mistakes = 0;  ///< one scan, start anywhere: > apart off
};

/// Ratios of seen to predicted: quantiles over the places.
struct RatioSpread {
  double p10 = 0.0, median = 0.0, p90 = 0.0;
  double correlation = 0.0;  ///< of the logarithms
};

struct Confirmation {
  std::vector<TrackedPlace> tracked;
  RatioSpread major_to_bound, minor_to_bound, major_to_edges, minor_to_edges, heading_to_bound;
  std::vector<RiskClass> risks;  ///< ascending
};

/// Runs filters at places drawn at random from those of the field, heading at random for tracking
/// and that of the twin for confusions; half of the latter places have a risk above 1 %, where the
/// field has such. The outcome depends on the seed and not on the number of threads.
Confirmation confirm(const Map& map, const FreeSpace& space, const LocalizabilityField& field,
                     const LocalizabilitySettings& settings,
                     const ConfirmationSettings& confirmation, const Progress& progress = {});

}  // namespace mapwright::navcore
