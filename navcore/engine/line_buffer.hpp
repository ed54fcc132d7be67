// Private to this folder: which line each ray of a scan meets first, in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "navcore/rays/laser.hpp"
#include "navcore/rays/ray_fan.hpp"

namespace mapwright::navcore::engine {

/// The rays of a laser by their number and by their bearing.
class BearingFan {
 public:
  explicit BearingFan(const LaserModel& laser) : rays_(laser) {
    if (laser.rays < 2) return;
    half_ = 0.5 * laser.fov_deg * std::numbers::pi / 180.0;
    rays_per_radian_ = static_cast<double>(laser.rays - 1) / (2.0 * half_);
  }

  const RayFan& rays() const { return rays_; }

  /// Calls `visit(first, end)` for the runs of rays with bearings from `right` to `left`, where
  /// right ∈ [−π, π] and right <= left < right + π.
  template <class Visit>
  void for_rays_between(double right, double left, Visit&& visit) const {
    for (const double turn : {0.0, -2.0 * std::numbers::pi}) {
      const double from = std::ceil((right + turn + half_) * rays_per_radian_ - kSlack);
      const double to = std::floor((left + turn + half_) * rays_per_radian_ + kSlack);
      const double last = static_cast<double>(rays_.size() - 1);
      if (to < 0.0 || from > last || from > to) continue;
      visit(static_cast<std::size_t>(std::max(from, 0.0)),
            static_cast<std::size_t>(std::min(to, last)) + 1);
    }
  }

 private:
  // Rounding of a bearing, in steps between rays: a ray through the end of a wall meets it.
  static constexpr double kSlack = 1e-9;

  RayFan rays_;
  double half_ = 0.0;
  double rays_per_radian_ = 1.0;
};

/// For each ray the nearest of the lines n·p = 1 (sensor frame) that were drawn on it; 1/r = n·u.
struct LineBuffer {
  explicit LineBuffer(std::size_t rays) : inverse(rays), normal_x(rays), normal_y(rays) {}

  void clear() { std::fill(inverse.begin(), inverse.end(), 0.0); }

  /// Draws the wall from a to b (sensor frame): on both sides, or on the left of a→b only. Nothing
  /// where its line passes through the laser.
  void draw(const BearingFan& fan, Point a, Point b, bool one_sided) {
    const double area = cross(a, b);
    if (area == 0.0 || (one_sided && area < 0.0)) return;
    const Point n{(b.y - a.y) / area, (a.x - b.x) / area};
    const Point right = area > 0.0 ? a : b;
    const double from = std::atan2(right.y, right.x);
    const Point left = area > 0.0 ? b : a;
    const double to = std::atan2(left.y, left.x);
    fan.for_rays_between(from, to < from ? to + 2.0 * std::numbers::pi : to,
                         [&](std::size_t first, std::size_t end) { raise(fan, n, first, end); });
  }

  void take(std::size_t ray, const LineBuffer& other) {
    if (other.inverse[ray] <= inverse[ray]) return;
    inverse[ray] = other.inverse[ray];
    normal_x[ray] = other.normal_x[ray];
    normal_y[ray] = other.normal_y[ray];
  }

  std::vector<double> inverse;             ///< 1/r, 0 for no line
  std::vector<double> normal_x, normal_y;  ///< n

 private:
  void raise(const BearingFan& fan, Point n, std::size_t first, std::size_t end) {
    const double* const x = fan.rays().x();
    const double* const y = fan.rays().y();
    for (std::size_t i = first; i < end; ++i) {
      const double value = n.x * x[i] + n.y * y[i];
      const bool nearer = value > inverse[i];
      inverse[i] = nearer ? value : inverse[i];
      normal_x[i] = nearer ? n.x : normal_x[i];
      normal_y[i] = nearer ? n.y : normal_y[i];
    }
  }
};

}  // namespace mapwright::navcore::engine
