#include "converter/detective/web_mercator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>

#include "converter/detective/known_grids.hpp"

namespace mapwright::converter {
namespace {

constexpr double kRadius_m = 6378137.0;  // of Web Mercator's sphere
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLeastEasting_m = 166000.0, kMostEasting_m = 834000.0;  // of UTM, 80 S to 84 N
constexpr double kMostNorthing_m = 1.0e7;

struct Place {
  double longitude_deg = 0.0, latitude_deg = 0.0;
};

Place place_of(const Box& extent) {
  const double x = 0.5 * (extent.min_x + extent.max_x), y = 0.5 * (extent.min_y + extent.max_y);
  return {x / kRadius_m / kDegree, std::atan(std::sinh(y / kRadius_m)) / kDegree};
}

// Open sea between the longitudes 1.4 and 7.6 east, drawn with a margin to every coast: the Gulf of
// Guinea, the Mediterranean around the Balearic Islands, the North Sea, the Norwegian Sea.
constexpr GeoBox kSeas[] = {{1.4, -60.0, 7.6, 3.9}, {1.4, 37.3, 7.6, 38.4}, {1.4, 40.3, 7.6, 41.0},
                            {4.7, 38.4, 7.6, 40.3}, {1.9, 54.1, 7.6, 57.6}, {1.4, 57.6, 4.2, 63.5},
                            {1.4, 63.5, 7.6, 84.0}};

bool is_at_sea(const Place& place) {
  return std::any_of(std::begin(kSeas), std::end(kSeas), [&](const GeoBox& sea) {
    return place.longitude_deg > sea.west_deg && place.longitude_deg < sea.east_deg &&
           place.latitude_deg > sea.south_deg && place.latitude_deg < sea.north_deg;
  });
}

std::string with_numbers(const char* format, double a, double b) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, a, b);
  return buffer;
}

// Of lengths that nobody rounded, one in twelve is as near to a multiple of 5 cm.
bool are_round(const DrawingEvidence& evidence) {
  constexpr std::size_t kLeastEdges = 24;
  return evidence.measured_edges >= kLeastEdges &&
         2 * evidence.round_edges >= evidence.measured_edges;
}

// The first argument that holds; empty where none does.
std::string argument(const Place& place, const DrawingEvidence& evidence) {
  const double ground = std::cos(place.latitude_deg * kDegree);  // metres a unit
  if (is_at_sea(place)) {
    return with_numbers("lies in the sea, at longitude %.2f, latitude %.2f", place.longitude_deg,
                        place.latitude_deg);
  }
  const auto& tread = evidence.tread;
  if (tread && *tread >= 0.28 && *tread <= 0.36 && *tread * ground < 0.24) {
    return with_numbers(
        "has steps that would be %.2f m deep on the ground, and are %.2f in its "
        "own units",
        *tread * ground, *tread);
  }
  // People are as wide everywhere: doors of 0.8 m and more, in their median, are what is built.
  const auto& door = evidence.door;
  if (door && *door >= 0.8 && *door <= 1.1 && *door * ground < 0.72) {
    return with_numbers(
        "has doors that would be %.2f m wide on the ground, and are %.2f in its own units",
        *door * ground, *door);
  }
  if (are_round(evidence)) {
    return with_numbers(
        "has walls of which %.0f %% are whole multiples of 5 cm in its own units, "
        "which are %.2f m on the ground",
        100.0 * static_cast<double>(evidence.round_edges) /
            static_cast<double>(evidence.measured_edges),
        ground);
  }
  return {};
}

}  // namespace

bool may_be_utm(const Crs& crs, const Box& extent) {
  const bool is_web_mercator = crs.code == "EPSG:3857" ||
                               crs.name.find("Pseudo-Mercator") != std::string::npos ||
                               crs.name.find("Web_Mercator") != std::string::npos;
  return is_web_mercator && extent.min_x >= kLeastEasting_m && extent.max_x <= kMostEasting_m &&
         extent.min_y >= 0.0 && extent.max_y <= kMostNorthing_m;
}

std::optional<std::string> doubt_about_web_mercator(const Box& extent,
                                                    const DrawingEvidence& evidence) {
  const auto because = argument(place_of(extent), evidence);
  if (because.empty()) return std::nullopt;
  const Point middle{0.5 * (extent.min_x + extent.max_x), 0.5 * (extent.min_y + extent.max_y)};
  const double north = utm_latitude_deg(middle);
  std::string where = "the zone is not told by the numbers";
  if (std::isfinite(north)) {
    where = with_numbers("latitude %.2f N, or %.0f km from the equator in the south; ", north,
                         (kMostNorthing_m - middle.y) / 1000.0) +
            where;
  }
  return "is said to be in Web Mercator, but " + because +
         ": its coordinates look like UTM, whose metres are those on the ground (" + where +
         "): if so, --override-crs EPSG:326ZZ (WGS 84, ZZ the zone), EPSG:258ZZ (Europe) or "
         "EPSG:327ZZ (south)";
}

}  // namespace mapwright::converter
