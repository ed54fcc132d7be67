#include "navcore/engine/planar.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::navcore::engine {

std::optional<Chord> clipped_to_circle(Point a, Point b, double radius_m) {
  const double squared_radius = radius_m * radius_m;
  const Point along = b - a;
  const double squared = squared_length(along);
  const double foot = -dot(a, along) / squared;
  const double squared_distance = squared_length(a + foot * along);
  if (squared_distance > squared_radius) return std::nullopt;
  const double half = std::sqrt((squared_radius - squared_distance) / squared);
  if (foot + half < 0.0 || foot - half > 1.0) return std::nullopt;
  return Chord{squared_length(a) > squared_radius ? a + std::max(0.0, foot - half) * along : a,
               squared_length(b) > squared_radius ? a + std::min(1.0, foot + half) * along : b};
}

bool Square::meets(Point a, Point b) const {
  if (std::min(a.x, b.x) > half_m || std::max(a.x, b.x) < -half_m) return false;
  if (std::min(a.y, b.y) > half_m || std::max(a.y, b.y) < -half_m) return false;
  return side(a, b) == Side::kBoth;
}

Square::Side Square::side(Point a, Point b) const {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const Point corner : corners()) {
    const double side = side_of_line(a, b, corner);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least >= 0.0) return Side::kLeft;
  return most <= 0.0 ? Side::kRight : Side::kBoth;
}

}  // namespace mapwright::navcore::engine
