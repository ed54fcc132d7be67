#include "converter/detective/known_grids.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "converter/gdal/crs.hpp"

namespace mapwright::converter {
namespace {

// Grids that buildings are drawn in and that one pair of numbers can be told by. UTM is not among
// them: its sixty zones use the same numbers.
constexpr const char* kGrids[] = {
    "EPSG:2154",  "EPSG:27572", "EPSG:27700", "EPSG:29903", "EPSG:2157",  "EPSG:28992",
    "EPSG:31370", "EPSG:3812",  "EPSG:2169",  "EPSG:2056",  "EPSG:21781", "EPSG:31254",
    "EPSG:31255", "EPSG:31256", "EPSG:31287", "EPSG:31466", "EPSG:31467", "EPSG:31468",
    "EPSG:31469", "EPSG:5514",  "EPSG:2180",  "EPSG:2178",  "EPSG:3006",  "EPSG:3067",
    "EPSG:3763",  "EPSG:3003",  "EPSG:3004",  "EPSG:2100",  "EPSG:3794",  "EPSG:3765",
    "EPSG:23700", "EPSG:3844",  "EPSG:7801",  "EPSG:2039",  "EPSG:5186",  "EPSG:6677",
    "EPSG:6669",  "EPSG:2193",  "EPSG:3577",  "EPSG:3826",  "EPSG:2326",  "EPSG:3414",
    "EPSG:3301",  "EPSG:3346",  "EPSG:3059",  "EPSG:25884", "EPSG:3347",  "EPSG:2263",
    "EPSG:2229",  "EPSG:2230",  "EPSG:2227",  "EPSG:3435",  "EPSG:2277",  "EPSG:2248",
    "EPSG:2249",  "EPSG:2285",  "EPSG:3035",  "EPSG:5070"};

double centrality(const GeoBox& area, double longitude, double latitude) {
  const double x = 2.0 * (longitude - area.west_deg) / (area.east_deg - area.west_deg) - 1.0;
  const double y = 2.0 * (latitude - area.south_deg) / (area.north_deg - area.south_deg) - 1.0;
  return 1.0 - std::max(std::abs(x), std::abs(y));
}

std::optional<GridPlace> place_in(const char* code, Point p) {
  const auto crs = parse_crs(code);
  if (!crs) return std::nullopt;  // of a PROJ database that does not know it
  const auto area = area_of_use(*crs);
  const auto place = longitude_latitude_on_own_datum(*crs, p.x, p.y);
  if (!area || !place) return std::nullopt;
  const double middle = centrality(*area, place->first, place->second);
  if (!(middle >= 0.0)) return std::nullopt;
  return GridPlace{crs->code, crs->name, place->first, place->second, crs->metres_per_unit, middle};
}

}  // namespace

std::vector<GridPlace> grids_holding(Point p) {
  std::vector<GridPlace> places;
  for (const char* code : kGrids) {
    if (auto place = place_in(code, p)) places.push_back(*std::move(place));
  }
  std::stable_sort(places.begin(), places.end(), [](const GridPlace& a, const GridPlace& b) {
    return a.centrality > b.centrality;
  });
  return places;
}

double utm_latitude_deg(Point p) {
  const auto crs = parse_crs("EPSG:32631");
  const auto place = crs ? longitude_latitude_on_own_datum(*crs, p.x, p.y) : std::nullopt;
  return place && place->second <= 84.0 ? place->second : std::nan("");
}

}  // namespace mapwright::converter
