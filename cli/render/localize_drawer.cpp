#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cli/render/drawers.hpp"
#include "cli/support/error.hpp"

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
  for (const char* key : {"particle_set", "particles"}) {
    if (iteration.contains(key) && iteration.at(key).is_array()) return iteration.at(key);
  }
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

void add_robot(const Json& pose, double radius_pt, Colour colour, const char* meaning,
               converter::Overlay& overlay) {
  const converter::OverlayPose robot{pose_of(pose), radius_pt, colour};
  add_legend(overlay, robot, meaning);
  overlay.items.emplace_back(robot);
}

}  // namespace

void draw_localization(const Json& answer, converter::Overlay& overlay,
                       std::optional<std::size_t> iteration) {
  const Json& shown = chosen_iteration(answer, iteration);
  add_particles(particles_of(shown), overlay);
  if (shown.contains("true_pose")) {
    add_robot(shown.at("true_pose"), 4.0, kTruth, "true pose", overlay);
  }
  if (shown.contains("estimate")) {
    add_robot(shown.at("estimate"), 2.8, kEstimate, "estimate", overlay);
  }
}

}  // namespace mapwright::cli
