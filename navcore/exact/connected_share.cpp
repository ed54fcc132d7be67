#include "navcore/exact/connected_share.hpp"

#include "navcore/exact/exact_planner.hpp"

namespace mapwright::navcore {
namespace {

constexpr int kTangents = 8;

ConnectedShare measure(const ExactPlanner& planner, double radius_m) {
  ConnectedShare share;
  share.radius_m = radius_m;
  const auto components = planner.components();
  share.components = components.size();
  for (const auto& component : components) share.free_area_m2 += component.area_m2;
  if (!components.empty()) share.largest_area_m2 = components.front().area_m2;
  return share;
}

}  // namespace

Result<std::vector<ConnectedShare>> connected_shares(const Map& map, RampPolicy ramps,
                                                     std::span<const double> radii_m) {
  std::vector<ConnectedShare> shares;
  for (const double radius_m : radii_m) {
    const auto planner = ExactPlanner::build(map, {radius_m, ramps, kTangents});
    if (!planner) return tl::unexpected(planner.error());
    shares.push_back(measure(*planner, radius_m));
  }
  return shares;
}

}  // namespace mapwright::navcore
