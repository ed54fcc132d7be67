#include "navcore/exact/clearance_table.hpp"

#include <algorithm>

#include "navcore/exact/travel_areas.hpp"
#include "navcore/named_places.hpp"

namespace mapwright::navcore {
namespace {

constexpr int kTangents = 8;

ClearanceRow measure(const TravelAreas& areas, double radius_m) {
  ClearanceRow row;
  row.radius_m = radius_m;
  row.free_area_m2 = areas.free_area_m2();
  row.components = areas.areas().size();
  if (row.components > 0) row.largest_area_m2 = areas.areas().front().area_m2;
  return row;
}

bool is_reached(const PlaceFinder& finder, const NamedPlace& place, const TravelAreas& areas,
                double radius_m) {
  const auto in_largest = [&](Point p) { return areas.area_at(p) == std::size_t{0}; };
  const auto p = finder.standing_point(place, radius_m, in_largest);
  return p && in_largest(*p);
}

}  // namespace

Result<ClearanceTable> clearance_table(const Map& map, RampPolicy ramps,
                                       std::span<const double> radii_m) {
  std::vector<double> radii(radii_m.begin(), radii_m.end());
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  const auto point = ExactPlanner::build(map, {0.0, ramps, kTangents});
  if (!point) return tl::unexpected(point.error());
  const FreeSpace space(map, ramps);
  const PlaceFinder finder(map, space);
  ClearanceTable table;
  table.places = finder.places().size();
  std::vector<char> lost(table.places);
  for (const double radius_m : radii) {
    auto planner = point->with_radius(radius_m);
    if (!planner) return tl::unexpected(planner.error());
    const TravelAreas areas(std::move(*planner), radius_m);
    table.rows.push_back(measure(areas, radius_m));
    for (std::size_t i = 0; i < lost.size(); ++i) {
      if (lost[i] != 0 || is_reached(finder, finder.places()[i], areas, radius_m)) continue;
      lost[i] = 1;
      table.rows.back().places_lost.push_back(finder.places()[i].name);
    }
  }
  return table;
}

}  // namespace mapwright::navcore
