// Weights for proposals: flattened where few of them matter.
#pragma once

#include <span>
#include <vector>

namespace mapwright::navcore {

/// Weights in proportion to exp(exponent × log weight); they sum up to 1.
std::vector<double> flattened_weights(std::span<const double> log_weights, double exponent);

/// The same with the greatest exponent, from `least_exponent` to 1 and to 1/64 of that range, that
/// leaves an effective share (effective sample size / size) of 0.15: a proposal made of fewer would
/// be drawn from what chance picked. With a least exponent above 0, what is impossible (−∞) stays
/// so.
std::vector<double> bearable_weights(std::span<const double> log_weights,
                                     double least_exponent = 0.0);

}  // namespace mapwright::navcore
