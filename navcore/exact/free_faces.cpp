#include "navcore/exact/free_faces.hpp"

#include <array>

#include "navcore/space/solid_rings.hpp"

namespace mapwright::navcore::exact {
namespace {

// Triangles that no line separates, `seed` first.
std::vector<std::uint32_t> face_around(std::uint32_t seed, const std::vector<Triangle>& triangles,
                                       std::vector<char>& visited) {
  std::vector<std::uint32_t> face{seed};
  visited[seed] = 1;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Triangle& triangle = triangles[face[i]];
    for (std::size_t side = 0; side < 3; ++side) {
      const std::int32_t across = triangle.neighbour[side];
      if (across < 0 || triangle.edge[side] >= 0 || visited[across] != 0) continue;
      visited[across] = 1;
      face.push_back(static_cast<std::uint32_t>(across));
    }
  }
  return face;
}

std::int64_t twice_area(const Tessellation& space, std::uint32_t triangle) {
  return orient(space.corner(triangle, 0), space.corner(triangle, 1), space.corner(triangle, 2));
}

// The middle of the face's largest triangle, map frame.
Point middle_of(const std::vector<std::uint32_t>& face, const Tessellation& space,
                const GridFrame& frame) {
  std::uint32_t largest = face[0];
  for (const std::uint32_t t : face) {
    if (twice_area(space, t) > twice_area(space, largest)) largest = t;
  }
  Point sum;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + frame.to_map(space.corner(largest, i));
  return (1.0 / 3.0) * sum;
}

}  // namespace

std::vector<Line> map_lines(const Map& map, const std::vector<BlockingSegment>& segments,
                            const GridFrame& frame) {
  std::vector<Line> lines;
  lines.reserve(segments.size() + 4);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    lines.push_back({frame.to_grid(segments[i].a), frame.to_grid(segments[i].b), i});
  }
  const Box box = map.border.box();
  const std::array<Point, 4> corners{{{box.min_x, box.min_y},
                                      {box.max_x, box.min_y},
                                      {box.max_x, box.max_y},
                                      {box.min_x, box.max_y}}};
  for (std::size_t i = 0; i < 4; ++i) {
    lines.push_back(
        {frame.to_grid(corners[i]), frame.to_grid(corners[(i + 1) % 4]), kBorderSource});
  }
  return lines;
}

Tessellation tessellate(const Map& map, RampPolicy ramps, const GridFrame& frame,
                        const std::vector<Line>& lines) {
  Tessellation space;
  space.work = node(lines);
  space.triangles = triangulate(space.work);
  space.is_free.resize(space.triangles.size());
  space.is_wall.assign(space.work.edges.size(), 1);
  const SolidRings rings(map, ramps);
  std::vector<char> visited(space.triangles.size());
  for (std::uint32_t seed = 0; seed < space.triangles.size(); ++seed) {
    if (visited[seed] != 0) continue;
    const auto face = face_around(seed, space.triangles, visited);
    const Point middle = middle_of(face, space, frame);
    if (!map.border.contains(middle) || rings.solid_at(middle)) continue;
    for (const std::uint32_t t : face) space.is_free[t] = 1;
  }
  return space;
}

}  // namespace mapwright::navcore::exact
