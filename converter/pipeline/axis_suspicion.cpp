#include "converter/pipeline/axis_suspicion.hpp"

#include <cmath>
#include <numbers>

#include "mapcore/point.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kMostCorners = 20000;
constexpr std::size_t kLeastCorners = 40;
constexpr std::size_t kFewCorners = 6;
constexpr double kRightAngleSlack = 0.026;  // cosine; 1.5°

double cosine_deg(double degrees) {
  return std::cos(degrees * (std::numbers::pi / 180.0));
}

bool is_right_angle(Point before, Point corner, Point after, double x_scale, double y_scale) {
  const Point in{x_scale * (corner.x - before.x), y_scale * (corner.y - before.y)};
  const Point out{x_scale * (after.x - corner.x), y_scale * (after.y - corner.y)};
  const double lengths = length(in) * length(out);
  return lengths > 0.0 && std::abs(dot(in, out)) < kRightAngleSlack * lengths;
}

}  // namespace

void AxisSuspicion::watch_corner(const SourceGeometry& geometry, std::size_t i) {
  const auto point = [&](std::size_t j) { return Point{geometry.xs[j], geometry.ys[j]}; };
  const Point corner = point(i);
  if (std::abs(corner.x) > 90.0 || std::abs(corner.y) > 90.0) return;
  ++corners_;
  if (is_right_angle(point(i - 1), corner, point(i + 1), cosine_deg(corner.y), 1.0)) {
    ++right_as_declared_;
  }
  if (is_right_angle(point(i - 1), corner, point(i + 1), 1.0, cosine_deg(corner.x))) {
    ++right_if_exchanged_;
  }
}

void AxisSuspicion::watch(const SourceGeometry& geometry) {
  if (corners_ >= kMostCorners) return;
  for (const auto& path : geometry.paths) {
    for (std::size_t i = path.first + 1; i + 1 < path.first + path.count; ++i)
      watch_corner(geometry, i);
  }
}

bool AxisSuspicion::is_suspect() const {
  return corners_ >= kLeastCorners && right_if_exchanged_ * 5 >= corners_ * 2 &&
         right_as_declared_ * 2 <= right_if_exchanged_;
}

bool AxisSuspicion::is_doubtful() const {
  return corners_ >= kFewCorners && right_if_exchanged_ * 3 >= corners_ * 2 &&
         right_as_declared_ * 4 <= corners_;
}

}  // namespace mapwright::converter
