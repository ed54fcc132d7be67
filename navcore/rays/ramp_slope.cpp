#include "navcore/rays/ramp_slope.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace mapwright::navcore {

std::optional<RampSlope> RampSlope::of(const Obstacle& ramp) {
  const auto normal = ramp_normal(ramp);
  if (!normal || normal->z <= 0.0 || ramp.segments.empty()) return std::nullopt;
  std::vector<Point> footprint = chain_points(ramp);
  const RampPlane plane(*normal, footprint);
  if (plane.gradient() == Point{0.0, 0.0}) return std::nullopt;
  return RampSlope(plane, std::move(footprint));
}

RampSlope::RampSlope(const RampPlane& plane, std::vector<Point> footprint)
    : plane_(plane), footprint_(std::move(footprint)) {
  const Point uphill = plane_.gradient();
  along_ = (1.0 / length(uphill)) * Point{-uphill.y, uphill.x};
}

// Cuts the footprint with the contour's line: the outline crosses it an even number of times, and
// between the first and second crossing, the third and fourth, … the line runs inside.
RampContour RampSlope::contour(double height_m) const {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < footprint_.size(); ++i) {
    const Point p = footprint_[i];
    const Point q = footprint_[(i + 1) % footprint_.size()];
    const double p_above = plane_.height_m(p) - height_m;
    const double q_above = plane_.height_m(q) - height_m;
    if ((p_above < 0.0) == (q_above < 0.0)) continue;
    crossings.push_back(dot(along_, p + (p_above / (p_above - q_above)) * (q - p)));
  }
  std::sort(crossings.begin(), crossings.end());
  RampContour contour{height_m, {}};
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    contour.pieces.push_back({crossings[i], crossings[i + 1]});
  }
  return contour;
}

double RampSlope::distance_m(const RampContour& contour, Point origin, Point direction) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double rise = dot(plane_.gradient(), direction);
  if (rise <= 0.0) return kNever;
  const double t = (contour.height_m - plane_.height_m(origin)) / rise;
  if (t < 0.0) return kNever;
  const double position = dot(along_, origin + t * direction);
  const bool inside = std::any_of(contour.pieces.begin(), contour.pieces.end(), [&](const auto& p) {
    return p.from <= position && position <= p.to;
  });
  return inside ? t : kNever;
}

}  // namespace mapwright::navcore
