#include "navcore/diff/common_places.hpp"

namespace mapwright::navcore {
namespace {

constexpr int kMostDraws = 200;

}  // namespace

CommonPlaces::CommonPlaces(const Map& before, const Map& after, RampPolicy ramps, double radius_m)
    : before_(before, ramps), after_(after, ramps), radius_m_(radius_m) {}

bool CommonPlaces::is_free(Point p) const {
  return before_.is_free(p, radius_m_) && after_.is_free(p, radius_m_);
}

std::optional<Point> CommonPlaces::sample(Random& random) const {
  for (int i = 0; i < kMostDraws; ++i) {
    const auto p = before_.sample(random, radius_m_);
    if (!p) return std::nullopt;
    if (after_.is_free(*p, radius_m_)) return p;
  }
  return std::nullopt;
}

std::optional<Point> CommonPlaces::sample_in(const Box& box, Random& random) const {
  for (int i = 0; i < kMostDraws; ++i) {
    const double x = random.uniform(box.min_x, box.max_x);
    const double y = random.uniform(box.min_y, box.max_y);
    if (is_free({x, y})) return Point{x, y};
  }
  return std::nullopt;
}

}  // namespace mapwright::navcore
