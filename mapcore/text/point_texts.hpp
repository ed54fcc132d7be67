// Private to this folder: points of a grid made text, many before the first is needed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "mapcore/grid_point.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright::text {

/// The lines "x;y;⏎" of up to kMost points. All are as long in memory, so that copying one is a
/// move or two; and what was written last is not read at once, which the processor would wait for.
class PointTexts {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr std::size_t kBytes = 32;  ///< of a line, at most

  /// Takes the place of what was there.
  void set(std::span<const GridPoint> points, const DecimalFormat& format);

  /// Copies line `i` to `at` and moves `at` behind it; writes kBytes, whatever its length.
  void append(std::size_t i, char*& at) const {
    std::memcpy(at, lines_[i].data(), kBytes);
    at += sizes_[i];
  }

 private:
  std::array<std::array<char, kBytes>, kMost> lines_;
  std::array<std::uint8_t, kMost> sizes_;
};

}  // namespace mapwright::text
