#include "converter/frame/origin.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "converter/frame/local_frame.hpp"

namespace mapwright::converter {
namespace {

Result<void> check_place(const Georeference& g) {
  if (!std::isfinite(g.origin_latitude_deg) || std::abs(g.origin_latitude_deg) > 90.0) {
    return usage_failure("--origin: latitude " + std::to_string(g.origin_latitude_deg) +
                         " is beyond ±90: the order is LAT,LON, or X,Y with --origin-crs");
  }
  if (!std::isfinite(g.origin_longitude_deg) || std::abs(g.origin_longitude_deg) > 360.0) {
    return usage_failure("--origin: longitude " + std::to_string(g.origin_longitude_deg) +
                         " is beyond ±360: the order is LAT,LON, or X,Y with --origin-crs");
  }
  return {};
}

// In (−180, 180].
double wrapped(double degrees) {
  const double rest = std::remainder(degrees, 360.0);
  return rest == -180.0 ? 180.0 : rest;
}

Result<void> place_by_crs(const FrameOptions& options, Georeference& g) {
  const auto crs = parse_crs(options.origin_crs);
  if (!crs) return tl::unexpected(crs.error());
  const auto transform = CrsTransform::create(*crs);
  if (!transform) return tl::unexpected(transform.error());
  double x = options.origin[0];
  double y = options.origin[1];
  if (!crs->geographic) g.heading_deg = wrapped(g.heading_deg + grid_north_deg(*transform, x, y));
  transform->to_wgs84({&x, 1}, {&y, 1});
  g.origin_longitude_deg = x;
  g.origin_latitude_deg = y;
  if (!std::isfinite(x)) {
    return usage_failure("--origin: " + std::to_string(options.origin[0]) + "," +
                         std::to_string(options.origin[1]) + " is no place in " + crs->title());
  }
  return {};
}

}  // namespace

double grid_north_deg(const CrsTransform& crs, double x, double y) {
  constexpr double kReach_m = 50.0;
  std::array<double, 3> xs{x, x, x};
  std::array<double, 3> ys{y, y - kReach_m, y + kReach_m};
  crs.to_wgs84(xs, ys);
  Georeference here;
  here.origin_longitude_deg = xs[0];
  here.origin_latitude_deg = ys[0];
  const LocalFrame frame(here);
  const Point north = frame.to_map(GeoPoint{xs[2], ys[2]}) - frame.to_map(GeoPoint{xs[1], ys[1]});
  return std::atan2(north.x, north.y) * (180.0 / std::numbers::pi);
}

Result<Georeference> resolve_frame(const FrameOptions& options, double fallback_latitude_deg,
                                   double fallback_longitude_deg) {
  Georeference g;
  g.heading_deg = wrapped(options.heading_deg);
  g.projection = options.projection;
  if (options.origin.empty()) {
    g.origin_latitude_deg = fallback_latitude_deg;
    g.origin_longitude_deg = fallback_longitude_deg;
  } else if (options.origin_crs.empty()) {
    g.origin_latitude_deg = options.origin[0];
    g.origin_longitude_deg = options.origin[1];
  } else if (auto placed = place_by_crs(options, g); !placed) {
    return tl::unexpected(placed.error());
  }
  if (options.origin.size() > 2) g.origin_height_m = options.origin[2];
  if (auto checked = check_place(g); !checked) return tl::unexpected(checked.error());
  return g;
}

}  // namespace mapwright::converter
