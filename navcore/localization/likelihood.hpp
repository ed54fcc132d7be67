// How well a perceived scan agrees with a synthetic one.
#pragma once

#include <cstdint>
#include <span>

namespace mapwright::navcore {

enum class LikelihoodKind : std::uint8_t {
  kReport,  ///< Eq. (4)-(6) to the letter
  kRobust,  ///< a floor under both sides of Eq. (5), tempered product in place of Eq. (6)
};

/// The sensor model, Eq. (5) of the report, and how single beams become a weight.
///
///     Δ = perceived − synthetic                                     Eq. (4)
///     L(Δ) = α N(Δ; 0, σm) + β U(Δ; −RMAX, 0)                       Eq. (5)
///     w ← w · 1 / Σ_j 1/L(Δ_j)                                      Eq. (6)
///
/// The robust kind adds γ/RMAX to L where Δ > 0, so that no single beam that passes an edge can
/// kill a particle, and multiplies: w ← w · (Π_j L(Δ_j))^τ (docs/localization.md says why).
struct LikelihoodModel {
  LikelihoodKind kind = LikelihoodKind::kRobust;
  double alpha = 1.0;
  double beta = 0.1;
  double gamma = 0.0;    ///< robust only: floor for beams longer than the map says
  double sigma_m = 0.5;  ///< σm, a standard deviation (the report says variance, but gives metres)
};

/// The report's parameters.
constexpr LikelihoodModel report_likelihood() {
  return {LikelihoodKind::kReport, 1.0, 0.1, 0.0, 0.5};
}

/// Logarithm of the factor by which the scan changes a particle's weight, τ = 1. Both spans hold
/// one range a beam, metres in [0, max_range_m].
///
/// Report: −log Σ_j 1/L(Δ_j), summed relative to its greatest term, so that it is finite for every
/// scan as long as alpha > 0, where a plain sum would overflow. With alpha = 0 a beam longer than
/// the map says has L = 0 and the factor is −∞.
/// Robust: Σ_j log L(Δ_j); finite if beta and gamma are positive.
double log_weight_factor(std::span<const double> perceived, std::span<const double> synthetic,
                         const LikelihoodModel& model, double max_range_m);

}  // namespace mapwright::navcore
