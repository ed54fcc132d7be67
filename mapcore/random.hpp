// Random numbers that are the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace mapwright {

/// A generator handed from caller to callee: the same seed and stream give the same numbers
/// everywhere, which the standard library's distributions do not promise.
///
/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014). Streams
/// start at scrambled states, so that a particle, a trial or a thread can each have its own and the
/// result does not depend on who draws first.
class Random {
 public:
  using result_type = std::uint64_t;

  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mix(seed) ^ mix(mix(stream) + kGolden)) {}

  result_type operator()() { return mix(state_ += kGolden); }
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return UINT64_MAX; }

  /// In [0, 1), 53 bits.
  double uniform() { return static_cast<double>((*this)() >> 11U) * 0x1.0p-53; }

  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In 0 … n − 1; n > 0. Unbiased (Lemire 2019).
  std::uint64_t below(std::uint64_t n) {
    while (true) {
      const auto product = static_cast<Wide>((*this)()) * n;
      if (static_cast<std::uint64_t>(product) >= (0 - n) % n) {
        return static_cast<std::uint64_t>(product >> 64U);
      }
    }
  }

  /// Normal with mean 0 and standard deviation 1 (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  double normal(double mean, double standard_deviation) {
    return mean + standard_deviation * normal();
  }

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111eb;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace mapwright
