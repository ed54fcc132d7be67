#include "converter/importers/imported_map.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "converter/importers/outlines.hpp"
#include "converter/importers/ring_simplification.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {
namespace {

constexpr std::string_view kLabel = "wall";

// The double nearest to the decimals that will be written.
double rounded(double metres) {
  const double per_metre = std::round(1.0 / tolerance::kResolution_m);
  return std::round(metres * per_metre) / per_metre;
}

// From half cells to metres, to where they will be written: rounding must not make rings touch once
// they are simplified.
std::vector<std::vector<Point>> placed(const std::vector<LatticeRing>& rings,
                                       const OccupancyGrid& grid) {
  const Point along = unit_vector(grid.origin.theta);
  const Point across{-along.y, along.x};
  const double half_m = 0.5 * grid.resolution_m;
  std::vector<std::vector<Point>> result;
  for (const auto& ring : rings) {
    std::vector<Point>& points = result.emplace_back();
    for (const Point p : ring) {
      const Point place =
          grid.origin.position() + (half_m * (p.x + 1.0)) * along + (half_m * (p.y + 1.0)) * across;
      points.push_back({rounded(place.x), rounded(place.y)});
    }
  }
  return result;
}

Obstacle ring_obstacle(std::int64_t id, const std::vector<Point>& ring,
                       const ImportOptions& options) {
  Obstacle obstacle{id, ShapeType::kClosedPolygon, kLabel, {}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    obstacle.segments.push_back(
        {ring[i], ring[(i + 1) % ring.size()], options.height_m, options.in_out, kLabel});
  }
  return obstacle;
}

// The smallest counter-clockwise ring around a clockwise one, by index; they do not touch.
std::size_t ring_around(const std::vector<std::vector<Point>>& rings,
                        const std::vector<double>& areas_m2, std::size_t inner) {
  std::size_t best = rings.size();
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (areas_m2[r] <= -areas_m2[inner]) continue;
    if (best < rings.size() && areas_m2[r] >= areas_m2[best]) continue;
    if (side_of_ring(rings[r], rings[inner].front()) == PointSide::kInside) best = r;
  }
  return best;
}

Border border_around(const Map& map, const ImportOptions& options) {
  const Box box = extent(map).inflated(options.border_margin_m);
  if (map.obstacles.empty()) return {};
  return {std::floor(box.min_x), std::ceil(box.max_y), std::ceil(box.max_x), std::floor(box.min_y)};
}

std::vector<std::vector<Point>> worth_keeping(std::vector<std::vector<Point>> rings,
                                              double smallest_area_m2) {
  std::erase_if(
      rings, [&](const auto& ring) { return std::abs(signed_area_m2(ring)) < smallest_area_m2; });
  return rings;
}

}  // namespace

Map lines_to_map(std::span<const Line> lines, const ImportOptions& options) {
  Map map;
  for (const Line& line : lines) {
    if (line.a == line.b) continue;
    const auto id = static_cast<std::int64_t>(map.obstacles.size()) + 1;
    map.obstacles.push_back({id,
                             ShapeType::kOpenPolygon,
                             kLabel,
                             {{line.a, line.b, options.height_m, options.in_out, kLabel}}});
  }
  map.border = border_around(map, options);
  return map;
}

Map grid_to_map(const OccupancyGrid& grid, const ImportOptions& options) {
  const auto outlines =
      worth_keeping(placed(occupied_outlines(grid), grid), options.smallest_area_m2);
  const auto rings = simplified_rings(outlines, options.simplification_m);
  std::vector<double> areas_m2;
  for (const auto& ring : rings) areas_m2.push_back(signed_area_m2(ring));
  Map map;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    Obstacle obstacle = ring_obstacle(static_cast<std::int64_t>(r) + 1, rings[r], options);
    if (areas_m2[r] < 0.0) {
      const std::size_t outer = ring_around(rings, areas_m2, r);
      if (outer == rings.size()) continue;  // what is around it was too small to keep
      obstacle.semantic =
          obstacle.semantic.with_value(semantic_key::kInnerOf, std::to_string(outer + 1));
    }
    map.obstacles.push_back(std::move(obstacle));
  }
  map.border = border_around(map, options);
  return map;
}

}  // namespace mapwright::converter
