#include "navcore/deployment/cut_off_places.hpp"

namespace mapwright::navcore {
namespace {

// Where the robot does not fit beside the place, smaller ones are sent until one does, so that the
// gap can be named.
std::optional<Bottleneck> gap_to(const PlaceFinder& finder, const NamedPlace& place,
                                 const TravelAreas& areas, double radius_m) {
  constexpr int kSizes = 5;
  std::optional<Point> at;
  for (int size = kSizes; size > 0 && !at; --size) {
    at = finder.standing_point(place, radius_m * size / kSizes);
  }
  if (!at) return std::nullopt;
  auto gap = areas.planner().bottleneck(*at, areas.areas().front().at);
  return gap && gap->is_end ? std::nullopt : gap;
}

}  // namespace

std::vector<CutOffPlace> cut_off_places(const PlaceFinder& finder, const TravelAreas& areas,
                                        double radius_m) {
  std::vector<CutOffPlace> cut_off;
  if (areas.areas().empty()) return cut_off;
  const auto in_largest = [&](Point p) { return areas.area_at(p) == std::size_t{0}; };
  for (const auto& place : finder.places()) {
    const auto at = finder.standing_point(place, radius_m, in_largest);
    if (at && in_largest(*at)) continue;
    cut_off.push_back(
        {place.name, place.obstacles.front(), at, gap_to(finder, place, areas, radius_m)});
  }
  return cut_off;
}

}  // namespace mapwright::navcore
