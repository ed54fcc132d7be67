// Private to this folder: a perceived scan and a sensor model, laid out for the kernels.
#pragma once

#include <cstddef>
#include <span>

#include "navcore/engine/aligned.hpp"
#include "navcore/localization/likelihood.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore::engine {

/// Eq. (5) of the report as L(Δ) = 2^(log2_peak − steepness Δ²) + floor, with one floor where the
/// beam is shorter than the map says (Δ <= 0) and one where it is longer.
struct ScanWeight {
  /// Requires perceived.size() == laser.rays and model.alpha > 0.
  ScanWeight(std::span<const double> perceived, const LaserModel& laser,
             const LikelihoodModel& model);

  LikelihoodKind kind;
  float peak = 0.0F;       ///< α / (σm √2π)
  float log2_peak = 0.0F;  ///< logarithm of that to base 2
  float steepness = 0.0F;  ///< 1 / (2 σm² ln 2)
  float shorter_floor = 0.0F;
  float longer_floor = 0.0F;

  /// So many factors, each L with a floor or the peak, neither overflow nor underflow.
  std::size_t safe_factors = 1;

  AlignedFloats perceived;  ///< ranges, metres, padded to blocks
};

}  // namespace mapwright::navcore::engine
