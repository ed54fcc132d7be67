// The directions of a scan's rays.
#pragma once

#include <cstddef>
#include <vector>

#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

/// Unit vectors of the rays of a laser, component by component so that loops over them vectorise.
///
/// A ray's direction in the map is the heading's unit vector times the ray's own (as complex
/// numbers): every ray caster takes it from here, so that all cast the same rays. Where heading and
/// ray angle are multiples of 90° it is exact.
class RayFan {
 public:
  /// The directions relative to the heading.
  explicit RayFan(const LaserModel& laser);

  std::size_t size() const { return x_.size(); }
  Point operator[](std::size_t i) const { return {x_[i], y_[i]}; }
  const double* x() const { return x_.data(); }
  const double* y() const { return y_.data(); }

  /// The directions of `relative` in the frame in which the heading is measured; replaces what was
  /// held.
  void turn(const RayFan& relative, Angle heading);

 private:
  std::vector<double> x_, y_;
};

}  // namespace mapwright::navcore
