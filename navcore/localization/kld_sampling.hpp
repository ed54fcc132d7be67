// Adaptive NP: how many particles are enough.
#pragma once

#include <cstddef>
#include <span>

#include "mapcore/angle.hpp"

namespace mapwright::navcore {

/// KLD sampling (Fox, Adapting the Sample Size in Particle Filters Through KLD-Sampling, Int. J. of
/// Robotics Research 22, 2003; the report's [9]): with so many particles the error of the histogram
/// that they are drawn from stays below `epsilon` with the probability that `z` stands for.
struct KldSettings {
  double epsilon = 0.05;  ///< greatest Kullback-Leibler divergence, > 0
  double z = 2.326;       ///< upper quantile of the standard normal distribution; 2.326 is 99 %
  double bin_m = 0.25;    ///< side of the histogram's bins in x and y, > 0
  double bin_deg = 5.0;   ///< and their width in heading, > 0
  std::size_t least = 100;
};

/// Fox's Eq. (7), the chi-square quantile by Wilson and Hilferty: (k − 1) / 2ε · (1 − 2/(9(k − 1))
/// + √(2/(9(k − 1))) z)³ for k occupied bins; 1 for k <= 1. Not rounded.
double kld_sample_size(std::size_t bins, const KldSettings& settings);

/// How many bins the poses occupy.
std::size_t occupied_bins(std::span<const Pose> poses, const KldSettings& settings);

}  // namespace mapwright::navcore
