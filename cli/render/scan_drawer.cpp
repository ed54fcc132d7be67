#include <algorithm>

#include "cli/render/drawers.hpp"

namespace mapwright::cli {
namespace {

using converter::Colour;

constexpr Colour kRay = Colour::from_hex(0x56B4E9, 0.55);
constexpr Colour kSeen = Colour::from_hex(0x56B4E9, 0.16);
constexpr Colour kHit = Colour::from_hex(0x005B9A);

}  // namespace

Point point_of(const Json& xy) {
  return {xy.at(0).get<double>(), xy.at(1).get<double>()};
}

Pose pose_of(const Json& pose) {
  return {pose.at("x").get<double>(), pose.at("y").get<double>(),
          Angle::from_degrees(pose.at("theta_deg").get<double>())};
}

void add_legend(converter::Overlay& overlay, converter::OverlayItem sample, std::string text) {
  const bool known = std::any_of(overlay.legend.begin(), overlay.legend.end(),
                                 [&](const auto& entry) { return entry.text == text; });
  if (!known) overlay.legend.push_back({std::move(sample), std::move(text)});
}

void add_scan(converter::Overlay& overlay, const Pose& pose, std::span<const double> angles_deg,
              std::span<const double> ranges_m, double max_range_m) {
  const Point origin = pose.position();
  converter::OverlayPath seen{{origin}, {kRay, 0.0}, true, kSeen};
  converter::OverlaySegments rays{{}, {kRay, 0.35}};
  converter::OverlayDots hits{{}, 1.3, kHit};
  for (std::size_t i = 0; i < std::min(angles_deg.size(), ranges_m.size()); ++i) {
    const Point end = origin + ranges_m[i] * unit_vector_deg(pose.theta.degrees() + angles_deg[i]);
    seen.points.push_back(end);
    rays.segments.emplace_back(origin, end);
    if (ranges_m[i] < max_range_m) hits.centres.push_back(end);
  }
  add_legend(overlay, rays, "laser ray");
  add_legend(overlay, hits, "hit");
  overlay.items.insert(overlay.items.end(), {seen, rays, hits});
}

void add_robot(converter::Overlay& overlay, const Pose& pose, double radius_pt, Colour colour,
               std::string meaning) {
  const converter::OverlayPose robot{pose, radius_pt, colour};
  add_legend(overlay, robot, std::move(meaning));
  overlay.items.emplace_back(robot);
}

void draw_scans(const Json& answer, converter::Overlay& overlay) {
  const auto angles_deg = answer.at("angles_deg").get<std::vector<double>>();
  const double max_range_m = answer.at("max_range").get<double>();
  for (const auto& scan : answer.at("scans")) {
    const auto ranges_m = scan.at("ranges").get<std::vector<double>>();
    const Pose pose = pose_of(scan.at("pose"));
    add_scan(overlay, pose, angles_deg, ranges_m, max_range_m);
    add_robot(overlay, pose, 3.5, kRobotColour, "robot");
  }
}

}  // namespace mapwright::cli
