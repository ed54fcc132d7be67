// Moves a pose to where its scan fits another one best.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "navcore/localizability/scan_information.hpp"
#include "navcore/localizability/twin_search.hpp"

namespace mapwright::navcore {
namespace {

// Widths of the blunt likelihoods on the way to the true one, metres, and steps at each.
constexpr double kWidths_m[] = {0.6, 0.25, 0.1};
constexpr int kSteps = 3;

// On the way, this share of the beams has to agree within twice the width, or it leads nowhere.
constexpr double kLeastAlike = 0.75;

constexpr double kLongestStep_m = 0.5;
constexpr double kLargestTurn_rad = 0.15;
constexpr double kStill_m = 1e-4;

// Solves the symmetric 3×3 system by Cholesky's method; false where it is not positive definite.
bool solve(const PoseInformation& m, const double (&b)[3], double (&x)[3]) {
  const double l00 = std::sqrt(m.xx);
  const double l10 = m.xy / l00, l20 = m.xt / l00;
  const double d1 = m.yy - l10 * l10;
  const double l11 = std::sqrt(d1);
  const double l21 = (m.yt - l20 * l10) / l11;
  const double d2 = m.tt - l20 * l20 - l21 * l21;
  if (!(m.xx > 0.0 && d1 > 0.0 && d2 > 0.0)) return false;
  const double l22 = std::sqrt(d2);
  const double y0 = b[0] / l00;
  const double y1 = (b[1] - l10 * y0) / l11;
  const double y2 = (b[2] - l20 * y0 - l21 * y1) / l22;
  x[2] = y2 / l22;
  x[1] = (y1 - l21 * x[2]) / l11;
  x[0] = (y0 - l10 * x[1] - l20 * x[2]) / l00;
  return true;
}

double share_alike(std::span<const RangeGradient> here, std::span<const RangeGradient> there,
                   double width_m) {
  std::size_t alike = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    alike += std::abs(here[i].range_m - there[i].range_m) < width_m ? 1 : 0;
  }
  return static_cast<double>(alike) / static_cast<double>(here.size());
}

// One step of iteratively reweighted least squares (Geman and McClure's weights: ranges that differ
// by much more than the width hardly count). Returns how far it moved; negative: nowhere to go.
double step(std::span<const RangeGradient> scan, std::span<const RangeGradient> there,
            double width_m, const Pose& aim, const TwinSettings& settings, Pose& pose) {
  const double per_m2 = 1.0 / (width_m * width_m);
  PoseInformation information;
  double b[3] = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!there[i].echo) continue;
    const double delta = scan[i].range_m - there[i].range_m;
    const double share = 1.0 / (1.0 + delta * delta * per_m2);
    const double weight = per_m2 * share * share;
    information.add(there[i].by_x, there[i].by_y, there[i].by_theta, weight);
    b[0] += weight * there[i].by_x * delta;
    b[1] += weight * there[i].by_y * delta;
    b[2] += weight * there[i].by_theta * delta;
  }
  if (settings.compass_sigma_deg) {
    const double sigma = *settings.compass_sigma_deg * std::numbers::pi / 180.0;
    information.tt += 0.5 / (sigma * sigma);
    b[2] += 0.5 / (sigma * sigma) * (aim.theta - pose.theta).wrapped().radians();
  }
  // A little damping keeps directions that the scan does not tell where they are.
  information.xx += 1.0;
  information.yy += 1.0;
  information.tt += 1.0;
  double x[3];
  if (!solve(information, b, x)) return -1.0;
  const double scale = std::min({1.0, kLongestStep_m / (1e-12 + std::hypot(x[0], x[1])),
                                 kLargestTurn_rad / (1e-12 + std::abs(x[2]))});
  pose = {pose.x + scale * x[0], pose.y + scale * x[1],
          Angle::from_radians(pose.theta.radians() + scale * x[2])};
  return scale * (std::hypot(x[0], x[1]) + std::abs(x[2]));
}

}  // namespace

std::optional<Pose> fitted(GradientCaster::Local& caster, std::span<const RangeGradient> scan,
                           const Pose& pose, Pose start, const TwinSettings& settings,
                           const BeamNoise& noise) {
  std::vector<RangeGradient> there(scan.size());
  const auto approach = [&](double width_m) {
    for (int i = 0; i < kSteps; ++i) {
      caster.cast(start, there);
      const double moved = step(scan, there, width_m, pose, settings, start);
      if (moved < kStill_m) break;
    }
  };
  for (const double width_m : kWidths_m) {
    if (width_m < 2.0 * noise.sigma_m()) continue;
    approach(width_m);
    if (share_alike(scan, there, 2.0 * width_m) < kLeastAlike) return std::nullopt;
  }
  approach(2.0 * noise.sigma_m());
  return start;
}

}  // namespace mapwright::navcore
