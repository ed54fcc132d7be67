#include "navcore/localizability/edge_information.hpp"

#include <cassert>
#include <numbers>

namespace mapwright::navcore {
namespace {

// A jump has to stand out of the noise of both ranges.
constexpr double kJump = 4.0;

// Two beams on one wall differ in where it lies by rounding only.
constexpr double kMore = 1.0 + 1e-6;

// 1/r at which the line that a beam met lies in another direction; 1/RMAX for no echo: a wall that
// goes on out of range has no edge there.
double inverse_range(const RangeGradient& beam, Point direction) {
  if (!beam.echo) return 1.0 / beam.range_m;
  return -(beam.by_x * direction.x + beam.by_y * direction.y) / beam.range_m;
}

// True if `near` hides what `far` meets at both directions: at a corner, where two walls meet, the
// nearer one changes.
bool hides(const RangeGradient& near, Point near_direction, const RangeGradient& far,
           Point far_direction) {
  const auto is_nearer = [&](Point direction) {
    return inverse_range(near, direction) > kMore * inverse_range(far, direction);
  };
  return near.echo && is_nearer(far_direction) && is_nearer(near_direction);
}

}  // namespace

PoseInformation edge_information(std::span<const RangeGradient> scan, const Pose& pose,
                                 const LaserModel& laser, const BeamNoise& noise) {
  assert(scan.size() == laser.rays);
  PoseInformation sum;
  if (laser.rays < 2) return sum;
  const double step =
      laser.fov_deg * std::numbers::pi / 180.0 / static_cast<double>(laser.rays - 1);
  const double seen = (1.0 - noise.occlusion()) * (1.0 - noise.occlusion());
  const double per_rad2 = seen * 12.0 / (step * step);
  const auto direction = [&](std::size_t i) {
    return unit_vector_deg(pose.theta.degrees() + ray_angle_deg(laser, i));
  };
  for (std::size_t i = 0; i + 1 < scan.size(); ++i) {
    const std::size_t near = scan[i].range_m < scan[i + 1].range_m ? i : i + 1;
    const std::size_t far = 2 * i + 1 - near;
    if (scan[far].range_m - scan[near].range_m < kJump * noise.sigma_m()) continue;
    const Point u = direction(near);
    if (!hides(scan[near], u, scan[far], direction(far))) continue;
    const double range_m = scan[near].range_m;
    sum.add(u.y / range_m, -u.x / range_m, -1.0, per_rad2);
  }
  return sum;
}

}  // namespace mapwright::navcore
