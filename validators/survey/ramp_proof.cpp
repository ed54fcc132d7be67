#include "validators/survey/ramp_proof.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mapwright::validators {
namespace {

// More than rounding changes in a rise; coordinates are no larger than this many times it.
constexpr double kSlack_m = 1e-6;
constexpr double kMostCoordinate_m = 1e7;

double length(const Normal& n) {
  return std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
}

// T202, T204.
bool is_sound(const Normal& normal, const ValidationOptions& options) {
  if (!(normal.z > 0.0)) return false;
  const double slope_deg =
      std::atan2(std::hypot(normal.x, normal.y), normal.z) * 180.0 / std::numbers::pi;
  return std::abs(length(normal) - 1.0) <= options.unit_normal_error &&
         slope_deg <= options.max_ramp_slope_deg;
}

// T130: how much higher the highest vertex is than the lowest.
bool rises_plausibly(const Obstacle& ramp, const Normal& normal, const ValidationOptions& options) {
  const Point gradient{-normal.x / normal.z, -normal.y / normal.z};
  double lowest = HUGE_VAL, highest = -HUGE_VAL, farthest = 0.0;
  for (const Segment& segment : ramp.segments) {
    for (const Point p : {segment.a, segment.b}) {
      lowest = std::min(lowest, dot(gradient, p));
      highest = std::max(highest, dot(gradient, p));
      farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
    }
  }
  const double rise_m = highest - lowest;
  return farthest < kMostCoordinate_m && options.min_ramp_rise_m + kSlack_m <= rise_m &&
         rise_m <= options.max_ramp_rise_m - kSlack_m;
}

}  // namespace

bool is_plain_ramp(const Obstacle& ramp, const ValidationOptions& options) {
  const auto normal = ramp_normal(ramp);
  const bool is_flat = std::none_of(ramp.segments.begin(), ramp.segments.end(),
                                    [](const Segment& s) { return s.height_m > 0.0; });
  return normal && is_flat && is_sound(*normal, options) && rises_plausibly(ramp, *normal, options);
}

}  // namespace mapwright::validators
