#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cli/render/drawers.hpp"
#include "cli/support/error.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::cli {
namespace {

using converter::Colour;

constexpr Colour kParticle = Colour::from_hex(0xB0005A, 0.55);
constexpr Colour kEstimate = Colour::from_hex(0xB0005A);
constexpr Colour kTruth = Colour::from_hex(0x0072B2);
constexpr double kHeaviest_pt = 2.2;
constexpr double kLightest_pt = 0.55;
constexpr int kSizes = 6;

const Json& chosen_iteration(const Json& answer, std::optional<std::size_t> iteration) {
  const Json& iterations = answer.at("iterations");
  const std::size_t count = iterations.size();
  const std::size_t number = iteration.value_or(count);
  if (number < 1 || number > count) {
    fail_usage("--iteration: the answer has iterations 1 to " + std::to_string(count));
  }
  return iterations.at(number - 1);
}

// Rows of x, y, theta_deg, weight. Without --with-particles an iteration only says how many.
const Json& particles_of(const Json& iteration) {
  if (iteration.contains("particle_set")) return iteration.at("particle_set");
  throw std::runtime_error("it holds no particles; run localize --with-particles");
}

// Area follows weight, in a few sizes: light particles first.
void add_particles(const Json& particles, converter::Overlay& overlay) {
  double heaviest = 0.0;
  for (const auto& p : particles) heaviest = std::max(heaviest, p.at(3).get<double>());
  std::vector<converter::OverlayDots> sizes;
  for (int i = 0; i < kSizes; ++i) {
    const double radius_pt = kLightest_pt + (kHeaviest_pt - kLightest_pt) * i / (kSizes - 1);
    sizes.push_back({{}, radius_pt, kParticle});
  }
  for (const auto& p : particles) {
    const double share = heaviest > 0.0 ? std::sqrt(p.at(3).get<double>() / heaviest) : 0.0;
    sizes[static_cast<std::size_t>(std::lround(share * (kSizes - 1)))].centres.push_back(
        point_of(p));
  }
  add_legend(overlay, converter::OverlayDots{{}, 1.6, kParticle}, "particle, larger: more weight");
  overlay.items.insert(overlay.items.end(), sizes.begin(), sizes.end());
}

// A recorded scan's beams say themselves where they look.
std::vector<double> angles_of(const Json& answer, const Json& iteration) {
  if (iteration.contains("angles_deg")) {
    return iteration.at("angles_deg").get<std::vector<double>>();
  }
  const Json& settings = answer.at("settings");
  navcore::LaserModel laser;
  laser.rays = settings.at("rays").get<std::size_t>();
  laser.fov_deg = settings.at("fov_deg").get<double>();
  std::vector<double> angles_deg;
  for (std::size_t i = 0; i < laser.rays; ++i) angles_deg.push_back(ray_angle_deg(laser, i));
  return angles_deg;
}

// What the robot saw, from where it stood.
void add_seen(const Json& answer, const Json& iteration, converter::Overlay& overlay) {
  const bool recorded = iteration.contains("ranges");
  const char* from = recorded ? "estimate" : "true_pose";
  const char* ranges = recorded ? "ranges" : "scan";
  if (!iteration.contains(from) || !iteration.contains(ranges)) return;
  add_scan(overlay, pose_of(iteration.at(from)), angles_of(answer, iteration),
           iteration.at(ranges).get<std::vector<double>>(),
           answer.at("settings").at("max_range").get<double>());
}

// The way up to the iteration shown.
void add_way(const Json& answer, const Json& shown, const char* key, Colour colour, double width_pt,
             const char* meaning, converter::Overlay& overlay) {
  converter::OverlayPath way{{}, {colour, width_pt}};
  for (const auto& iteration : answer.at("iterations")) {
    if (iteration.contains(key)) way.points.push_back(pose_of(iteration.at(key)).position());
    if (iteration.at("n") == shown.at("n")) break;
  }
  if (way.points.empty()) return;
  add_legend(overlay, way, meaning);  // from the first on, so that frames look alike
  if (way.points.size() < 2) return;
  overlay.items.emplace_back(std::move(way));
}

}  // namespace

void draw_localization(const Json& answer, converter::Overlay& overlay,
                       std::optional<std::size_t> iteration) {
  if (answer.contains("trials")) {
    throw std::runtime_error(
        "it sums many runs up; run localize on one of them, with --pose or without --windows");
  }
  const Json& shown = chosen_iteration(answer, iteration);
  const bool recorded = shown.contains("t");  // of a log
  add_seen(answer, shown, overlay);
  if (recorded) {
    add_way(answer, shown, "reference", kTruth, 2.4, "way by the reference", overlay);
    add_way(answer, shown, "estimate", kEstimate, 1.0, "way as estimated", overlay);
  }
  if (!recorded || shown.contains("particle_set")) add_particles(particles_of(shown), overlay);
  if (shown.contains("reference")) {
    add_robot(overlay, pose_of(shown.at("reference")), 4.5, kTruth, "reference");
  }
  if (shown.contains("true_pose")) {
    add_robot(overlay, pose_of(shown.at("true_pose")), 4.5, kTruth, "true pose");
  }
  if (shown.contains("estimate")) {
    add_robot(overlay, pose_of(shown.at("estimate")), 2.6, kEstimate, "estimate");
  }
}

}  // namespace mapwright::cli
