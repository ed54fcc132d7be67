// Finds out that longitude and latitude were exchanged.
#pragma once

#include <cstddef>

#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// Watches the corners of drawings in degrees. What people build has right angles; exchanged axes
/// stretch them by the cosine of the latitude, so a drawing with few right angles as it is and many
/// with the axes exchanged is suspect. Says nothing of round, random or axis-parallel drawings.
class AxisSuspicion {
 public:
  /// `geometry` in degrees, x longitude and y latitude as declared.
  void watch(const SourceGeometry& geometry);

  /// The evidence is beyond doubt.
  bool is_suspect() const;
  /// There is as much evidence as a small drawing gives.
  bool is_doubtful() const;

 private:
  void watch_corner(const SourceGeometry& geometry, std::size_t i);

  std::size_t corners_ = 0;
  std::size_t right_as_declared_ = 0;
  std::size_t right_if_exchanged_ = 0;
};

}  // namespace mapwright::converter
