#include "navcore/exact/boundary.hpp"

namespace mapwright::navcore::exact {
namespace {

struct Side {
  std::uint32_t triangle;
  std::uint32_t i;
};

BoundarySide to_boundary(const Tessellation& space, Side side) {
  const Triangle& triangle = space.triangles[side.triangle];
  return {triangle.corner[side.i], triangle.corner[(side.i + 1) % 3],
          static_cast<std::uint32_t>(triangle.edge[side.i]), side.triangle};
}

// The next side that bounds the free space: turns around the end of `side` through free triangles.
Side next_bounding(const Tessellation& space, Side side) {
  Side next{side.triangle, (side.i + 1) % 3};
  while (space.is_open(next.triangle, next.i)) {
    const auto across =
        static_cast<std::uint32_t>(space.triangles[next.triangle].neighbour[next.i]);
    const auto back = static_cast<std::uint32_t>(
        side_towards(space.triangles[across], static_cast<std::int32_t>(next.triangle)));
    next = {across, (back + 1) % 3};
  }
  return next;
}

}  // namespace

std::vector<BoundaryCycle> boundary_cycles(const Tessellation& space) {
  std::vector<BoundaryCycle> cycles;
  std::vector<char> visited(3 * space.triangles.size());
  for (std::uint32_t t = 0; t < space.triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (space.is_free[t] == 0 || visited[3 * t + i] != 0 || space.is_open(t, i)) continue;
      BoundaryCycle cycle;
      Side side{t, i};
      do {
        visited[3 * side.triangle + side.i] = 1;
        cycle.push_back(to_boundary(space, side));
        side = next_bounding(space, side);
      } while (side.triangle != t || side.i != i);
      cycles.push_back(std::move(cycle));
    }
  }
  return cycles;
}

}  // namespace mapwright::navcore::exact
