#include "navcore/engine/near_line.hpp"

#include <algorithm>
#include <limits>

#include "navcore/engine/iso_line.hpp"

namespace mapwright::navcore::engine {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Stands for 1 / 0: a laser that touches what stops it.
constexpr double kLargestInverse = 1e30;

template <class Distance>
void cast_all_rays(const BeamTable& beams, const Pose& pose, Point a, Point b, Distance&& distance,
                   float* inverse_ranges) {
  const Point ahead = unit_vector_deg(pose.theta.degrees());
  for (std::size_t i = 0; i < beams.rays; ++i) {
    const Point r = beams.direction[i];
    const Point u{ahead.x * r.x - ahead.y * r.y, ahead.y * r.x + ahead.x * r.y};
    const double t = distance(u, a - pose.position(), b - pose.position());
    const auto inverse = static_cast<float>(std::min(1.0 / t, kLargestInverse));
    inverse_ranges[i] = std::max(inverse_ranges[i], inverse);
  }
}

}  // namespace

double distance_to_segment(Point u, Point a, Point b) {
  const double side_a = cross(u, a);
  const double side_b = cross(u, b);
  if (side_a == 0.0 && side_b == 0.0) {
    const double along_a = dot(u, a);
    const double along_b = dot(u, b);
    if (std::max(along_a, along_b) < 0.0) return kNever;
    return std::max(0.0, std::min(along_a, along_b));
  }
  if ((side_a < 0.0 && side_b < 0.0) || (side_a > 0.0 && side_b > 0.0)) return kNever;
  const double t = cross(a, b) / (side_b - side_a);
  return t >= 0.0 ? std::abs(t) : kNever;
}

double distance_to_one_sided(Point u, Point a, Point b) {
  return cross(u, b - a) > 0.0 ? distance_to_segment(u, a, b) : kNever;
}

void cast_at_item(const Scene& scene, std::uint32_t item, double height_m, const BeamTable& beams,
                  const Pose& pose, float* inverse_ranges) {
  if (!scene.is_ramp(item)) {
    const SceneSegment& s = scene.segments()[item];
    cast_all_rays(beams, pose, s.a, s.b, distance_to_segment, inverse_ranges);
    return;
  }
  for (const OneSidedSegment& line : iso_lines(scene.ramp(item), height_m)) {
    cast_all_rays(beams, pose, line.a, line.b, distance_to_one_sided, inverse_ranges);
  }
}

}  // namespace mapwright::navcore::engine
