#include "navcore/localizability/scan_information.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace mapwright::navcore {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-10;

/// A symmetric 2×2 matrix as a sum over its axes.
struct Axes {
  double greatest = 0.0, least = 0.0;  ///< eigenvalues
  Angle least_direction;               ///< of the eigenvector, in (−90°, 90°]
};

Axes axes_of(double xx, double xy, double yy) {
  const double mean = 0.5 * (xx + yy);
  const double radius = std::hypot(0.5 * (xx - yy), xy);
  const double greatest_direction = 0.5 * std::atan2(2.0 * xy, xx - yy);
  double across = greatest_direction + 0.5 * std::numbers::pi;
  if (across > 0.5 * std::numbers::pi) across -= std::numbers::pi;
  return {mean + radius, mean - radius, Angle::from_radians(across)};
}

double deviation(double information, double greatest) {
  return information > kRounding * greatest ? 1.0 / std::sqrt(information) : kUnknown;
}

// What remains of tt when the position is not known: tt − v⁺, v = xt, yt taken along the axes of
// the position's information. Where an axis has no information, xt and yt have no part along it.
double heading_information(const PoseInformation& i) {
  const Axes axes = axes_of(i.xx, i.xy, i.yy);
  const Point least = unit_vector(axes.least_direction);
  const double on_least = least.x * i.xt + least.y * i.yt;
  const double on_greatest = least.x * i.yt - least.y * i.xt;
  double rest = i.tt;
  if (axes.greatest > 0.0) rest -= on_greatest * on_greatest / axes.greatest;
  if (axes.least > kRounding * axes.greatest) rest -= on_least * on_least / axes.least;
  return rest;
}

}  // namespace

PoseInformation& PoseInformation::operator+=(const PoseInformation& other) {
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  xt += other.xt;
  yt += other.yt;
  tt += other.tt;
  return *this;
}

void PoseInformation::add(double by_x, double by_y, double by_theta, double per_m2) {
  xx += per_m2 * by_x * by_x;
  xy += per_m2 * by_x * by_y;
  yy += per_m2 * by_y * by_y;
  xt += per_m2 * by_x * by_theta;
  yt += per_m2 * by_y * by_theta;
  tt += per_m2 * by_theta * by_theta;
}

PoseInformation scan_information(std::span<const RangeGradient> scan, double per_m2) {
  PoseInformation sum;
  for (const RangeGradient& beam : scan) {
    if (beam.echo) sum.add(beam.by_x, beam.by_y, beam.by_theta, per_m2);
  }
  return sum;
}

PoseInformation scan_information(const GradientCaster& caster, const Pose& pose,
                                 const LaserModel& laser, double per_m2) {
  std::vector<RangeGradient> scan(laser.rays);
  caster.cast(pose, laser, scan);
  return scan_information(scan, per_m2);
}

double AccuracyBound::along_m(Angle direction) const {
  const Point u = unit_vector(direction - major_direction);
  const auto part = [](double share, double deviation_m) {
    return share == 0.0 ? 0.0 : share * deviation_m;
  };
  return std::hypot(part(u.x, major_m), part(u.y, minor_m));
}

AccuracyBound accuracy_bound(const PoseInformation& i) {
  const double per_tt = i.tt > 0.0 ? 1.0 / i.tt : 0.0;
  const Axes axes = axes_of(i.xx - i.xt * i.xt * per_tt, i.xy - i.xt * i.yt * per_tt,
                            i.yy - i.yt * i.yt * per_tt);
  // Measured against what is known with the heading given: what cancels in the difference is noise.
  const double greatest = std::max(i.xx + i.yy, 0.0);
  return {deviation(axes.least, greatest), deviation(axes.greatest, greatest), axes.least_direction,
          deviation(heading_information(i), i.tt)};
}

}  // namespace mapwright::navcore
