// Random shapes with a taste for the degenerate.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "mapcore/point.hpp"
#include "mapcore/random.hpp"

namespace mapwright::test {

/// Whether points may lie a few units in the last place beside each other.
enum class Nudges { kNo, kYes };

/// A point of a small grid (so that points repeat and lines overlap) or of the plane, or one moved
/// by a few units in the last place.
class PointSource {
 public:
  explicit PointSource(Random& random, Nudges nudges = Nudges::kYes)
      : random_(random),
        grid_(2 + random.below(8)),
        kind_(random.below(nudges == Nudges::kYes ? 4 : 3)) {}

  Point operator()() {
    const Point node{static_cast<double>(random_.below(grid_)),
                     static_cast<double>(random_.below(grid_))};
    switch (kind_) {
      case 0:
        return node;
      case 1:
        return {random_.uniform(-100.0, 100.0), random_.uniform(-100.0, 100.0)};
      case 2:
        return {0.125 * node.x + 1000.0, 0.25 * node.y - 70.7};
      default:
        return {nudged(1.0 + node.x), nudged(1.0 + node.y)};
    }
  }

 private:
  double nudged(double value) {
    const auto steps = random_.below(4);
    for (std::uint64_t i = 0; i < steps; ++i) value = std::nextafter(value, 1e9);
    return value;
  }

  Random& random_;
  std::uint64_t grid_;
  std::uint64_t kind_;
};

inline std::vector<Point> random_points(Random& random, std::size_t count,
                                        Nudges nudges = Nudges::kYes) {
  PointSource source(random, nudges);
  std::vector<Point> points(count);
  for (auto& p : points) p = source();
  return points;
}

/// A star-shaped ring, counter-clockwise: simple, apart from rounding.
inline std::vector<Point> star_ring(Random& random, std::size_t count) {
  std::vector<Point> ring(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double radius = random.uniform(1.0, 10.0);
    ring[i] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return ring;
}

}  // namespace mapwright::test
