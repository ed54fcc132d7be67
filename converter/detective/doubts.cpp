#include "converter/detective/doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace mapwright::converter {
namespace {

constexpr double kAreaMargin_deg = 1.0;  // areas of use are drawn roughly
constexpr double kLeastTread_m = 0.2;
constexpr double kGreatestTread_m = 0.6;
constexpr double kUsualTread_m = 0.3;
constexpr double kLeastMap_m = 0.5;

std::string with_numbers(const char* format, double a, double b = 0.0, double c = 0.0,
                         double d = 0.0) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, a, b, c, d);
  return buffer;
}

bool holds(const GeoBox& area, double longitude, double latitude) {
  const bool spans = area.west_deg > area.east_deg  // over the antimeridian
                         ? longitude >= area.west_deg - kAreaMargin_deg ||
                               longitude <= area.east_deg + kAreaMargin_deg
                         : longitude >= area.west_deg - kAreaMargin_deg &&
                               longitude <= area.east_deg + kAreaMargin_deg;
  return spans && latitude >= area.south_deg - kAreaMargin_deg &&
         latitude <= area.north_deg + kAreaMargin_deg;
}

Point middle_of(const Box& box) {
  return {0.5 * (box.min_x + box.max_x), 0.5 * (box.min_y + box.max_y)};
}

bool looks_like_degrees(const Crs& crs, const Box& extent) {
  return !crs.geographic && std::max(extent.width(), extent.height()) < 1.0 &&
         std::max(std::abs(extent.min_x), std::abs(extent.max_x)) <= 180.0 &&
         std::max(std::abs(extent.min_y), std::abs(extent.max_y)) <= 90.0;
}

// Distances between steps that follow each other, where they are parallel enough to have one.
std::vector<double> treads_of(const std::vector<Obstacle>& obstacles) {
  std::vector<double> treads;
  for (const auto& obstacle : obstacles) {
    if (obstacle.shape_type != ShapeType::kStairs) continue;
    for (std::size_t k = 1; k < obstacle.segments.size(); ++k) {
      const Segment& lower = obstacle.segments[k - 1];
      const Segment& upper = obstacle.segments[k];
      if (lower.height_m <= 0.0 || upper.height_m <= lower.height_m) continue;
      const Point between = 0.5 * (upper.a + upper.b) - 0.5 * (lower.a + lower.b);
      const Point along = lower.b - lower.a;
      const double reach = length(along);
      if (reach > 0.0) treads.push_back(std::abs(cross(along, between)) / reach);
    }
  }
  return treads;
}

std::string remedy_for(double tread_m, std::optional<double> latitude_deg) {
  constexpr double kFoot_m = 0.3048;
  const double factor = kUsualTread_m / tread_m;
  if (std::abs(factor / kFoot_m - 1.0) < 0.3) {
    return "; are its coordinates feet? In feet it would be " +
           with_numbers("%.2f m", tread_m * kFoot_m);
  }
  const double shrink = latitude_deg ? std::cos(*latitude_deg * (std::numbers::pi / 180.0)) : 1.0;
  if (latitude_deg && std::abs(factor * shrink - 1.0) < 0.15) {
    return "; are its coordinates metres on the ground that were called Web Mercator?";
  }
  return "; are unit and CRS of the source right?";
}

}  // namespace

std::optional<std::string> doubt_about_place(const Crs& crs, const Box& extent) {
  if (!crs.is_stated()) return std::nullopt;
  if (looks_like_degrees(crs, extent)) {
    return "is said to be in " + crs.title() + ", but " +
           with_numbers("x %.7g to %.7g, y %.7g to %.7g", extent.min_x, extent.max_x, extent.min_y,
                        extent.max_y) +
           " look like degrees: if they are, --override-crs EPSG:4326";
  }
  const auto area = area_of_use(crs);
  const auto transform = CrsTransform::create(crs, CrsTransform::Ways::kToWgs84);
  if (!area || !transform) return std::nullopt;
  const Point middle = middle_of(extent);
  std::array<double, 1> x{middle.x}, y{middle.y};
  transform->to_wgs84(x, y);
  if (std::isfinite(x[0]) && holds(*area, x[0], y[0])) return std::nullopt;
  return "is said to be in " + crs.title() + ", which is meant for " +
         with_numbers("longitudes %.4g to %.4g and latitudes %.4g to %.4g", area->west_deg,
                      area->east_deg, area->south_deg, area->north_deg) +
         (std::isfinite(x[0])
              ? with_numbers(", but lies at longitude %.4g, latitude %.4g", x[0], y[0])
              : ", but lies where it has no meaning") +
         ": is the CRS right, and the order of the axes? (--override-crs, --swap-axes)";
}

std::optional<std::string> doubt_about_scale(const Box& box, const std::vector<Obstacle>& obstacles,
                                             std::optional<double> latitude_deg) {
  if (box.is_empty()) return std::nullopt;
  if (std::max(box.width(), box.height()) < kLeastMap_m) {
    return with_numbers(
        "the whole map is %.3g by %.3g m: are the coordinates of its sources degrees, "
        "or of another unit?",
        box.width(), box.height());
  }
  auto treads = treads_of(obstacles);
  if (treads.empty()) return std::nullopt;
  std::nth_element(treads.begin(), treads.begin() + static_cast<std::ptrdiff_t>(treads.size() / 2),
                   treads.end());
  const double tread_m = treads[treads.size() / 2];
  if (tread_m >= kLeastTread_m && tread_m <= kGreatestTread_m) return std::nullopt;
  return with_numbers("a step of its stairs is %.2f m deep in the middle", tread_m) +
         remedy_for(tread_m, latitude_deg);
}

}  // namespace mapwright::converter
