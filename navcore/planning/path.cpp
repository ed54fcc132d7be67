#include "navcore/planning/path.hpp"

#include <algorithm>
#include <cmath>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::navcore {
namespace {

// Long legs are cut into pieces of about this length, whose boxes hold few segments.
constexpr double kPiece_m = 5.0;

double segment_distance_m(Point a, Point b, Point c, Point d) {
  if (meet(a, b, c, d).kind != Meeting::kNone) return 0.0;
  return std::min({distance(a, closest_point_on_segment(a, c, d)),
                   distance(b, closest_point_on_segment(b, c, d)),
                   distance(c, closest_point_on_segment(c, a, b)),
                   distance(d, closest_point_on_segment(d, a, b))});
}

// The least of `bound_m` and the distance from the leg ab to what blocks.
double leg_clearance_m(const SegmentIndex& index, Point a, Point b, double bound_m) {
  const auto pieces = static_cast<int>(std::ceil(distance(a, b) / kPiece_m));
  Point from = a;
  for (int i = 1; i <= pieces; ++i) {
    const Point to = i == pieces ? b : a + (static_cast<double>(i) / pieces) * (b - a);
    Box box = kEmptyBox;
    box.add(from);
    box.add(to);
    index.query(box.inflated(bound_m), [&](std::size_t s) {
      bound_m = std::min(bound_m, segment_distance_m(a, b, index[s].a, index[s].b));
      return bound_m > 0.0;
    });
    from = to;
  }
  return bound_m;
}

}  // namespace

double path_length_m(std::span<const Point> path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length_m += distance(path[i - 1], path[i]);
  return length_m;
}

std::optional<double> path_clearance_m(const FreeSpace& space, std::span<const Point> path) {
  if (path.empty()) return std::nullopt;
  const auto nearest = space.index().nearest(path.front());
  if (!nearest) return std::nullopt;
  double bound_m = nearest->distance_m;
  for (std::size_t i = 1; i < path.size(); ++i) {
    bound_m = leg_clearance_m(space.index(), path[i - 1], path[i], bound_m);
  }
  return bound_m;
}

bool is_free_path(const FreeSpace& space, std::span<const Point> path, double radius_m) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!space.is_free(path[i], radius_m)) return false;
    if (i > 0 && !space.is_free_way(path[i - 1], path[i], radius_m)) return false;
  }
  return true;
}

}  // namespace mapwright::navcore
