// Outlines of joined cells.
#include <algorithm>
#include <cstdint>
#include <map>

#include "converter/exporters/field.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

/// A corner of cells, by its column and row.
struct Corner {
  std::int64_t column = 0, row = 0;
  friend auto operator<=>(const Corner&, const Corner&) = default;
};

/// Sides of cells with nothing beyond, by where they begin; the cells are on their left.
using Sides = std::multimap<Corner, Corner>;

Sides sides_of(const Field& field, const std::vector<char>& held,
               const std::vector<std::size_t>& cells) {
  Sides sides;
  const auto columns = static_cast<std::int64_t>(field.columns);
  const auto rows = static_cast<std::int64_t>(field.rows);
  const auto is_held = [&](std::int64_t column, std::int64_t row) {
    return column >= 0 && column < columns && row >= 0 && row < rows &&
           held[static_cast<std::size_t>(row * columns + column)] != 0;
  };
  for (const std::size_t i : cells) {
    const auto c = static_cast<std::int64_t>(i) % columns;
    const auto r = static_cast<std::int64_t>(i) / columns;
    if (!is_held(c, r - 1)) sides.insert({{c, r}, {c + 1, r}});
    if (!is_held(c + 1, r)) sides.insert({{c + 1, r}, {c + 1, r + 1}});
    if (!is_held(c, r + 1)) sides.insert({{c + 1, r + 1}, {c, r + 1}});
    if (!is_held(c - 1, r)) sides.insert({{c, r + 1}, {c, r}});
  }
  return sides;
}

std::int64_t turn(Corner a, Corner b, Corner c) {
  return (b.column - a.column) * (c.row - b.row) - (b.row - a.row) * (c.column - b.column);
}

// Follows the sides from `from`. Where two cells touch with their corners only, it turns left: the
// cells are no neighbours, and the ring stays simple.
std::vector<Corner> take_ring(Sides& sides) {
  std::vector<Corner> ring{sides.begin()->first, sides.begin()->second};
  sides.erase(sides.begin());
  while (ring.back() != ring.front()) {
    const auto [begin, end] = sides.equal_range(ring.back());
    auto next = begin;
    for (auto it = begin; it != end; ++it) {
      if (turn(ring[ring.size() - 2], ring.back(), it->second) >
          turn(ring[ring.size() - 2], ring.back(), next->second)) {
        next = it;
      }
    }
    ring.push_back(next->second);
    sides.erase(next);
  }
  ring.pop_back();
  return ring;
}

std::vector<Point> path_of(const Field& field, const std::vector<Corner>& ring) {
  std::vector<Point> path;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner before = ring[(i + ring.size() - 1) % ring.size()];
    if (turn(before, ring[i], ring[(i + 1) % ring.size()]) == 0) continue;
    path.push_back({field.corner.x + field.cell_m * static_cast<double>(ring[i].column),
                    field.corner.y + field.cell_m * static_cast<double>(ring[i].row)});
  }
  return path;
}

}  // namespace

std::vector<std::vector<std::vector<Point>>> cell_polygons(const Field& field,
                                                           const std::vector<std::size_t>& cells) {
  std::vector<char> held(field.columns * field.rows);
  for (const std::size_t i : cells) held[i] = 1;
  Sides sides = sides_of(field, held, cells);
  std::vector<std::vector<std::vector<Point>>> polygons;
  std::vector<std::vector<Point>> holes;
  while (!sides.empty()) {
    auto path = path_of(field, take_ring(sides));
    if (signed_area_m2(path) > 0.0) {
      polygons.push_back({std::move(path)});
    } else {
      holes.push_back(std::move(path));
    }
  }
  for (auto& hole : holes) {
    // The middle of a hole's first side is no corner of any ring.
    const Point at = 0.5 * (hole[0] + hole[1]);
    for (auto& polygon : polygons) {
      if (side_of_ring(polygon.front(), at) == PointSide::kInside) {
        polygon.push_back(std::move(hole));
        break;
      }
    }
  }
  return polygons;
}

}  // namespace mapwright::converter
