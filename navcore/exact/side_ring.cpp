#include "navcore/exact/side_ring.hpp"

#include <array>
#include <bit>

namespace mapwright::navcore::exact {

SideRings::SideRings(const Tessellation& space)
    : space_(space),
      exists_(3 * space.triangles.size()),
      twin_(3 * space.triangles.size(), -1),
      next_(3 * space.triangles.size()),
      previous_(3 * space.triangles.size()) {
  for (std::uint32_t t = 0; t < space.triangles.size(); ++t) {
    if (space.is_free[t] == 0) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t side = 3 * t + i;
      exists_[side] = 1;
      next_[side] = 3 * t + (i + 1) % 3;
      previous_[side] = 3 * t + (i + 2) % 3;
      if (!space.is_open(t, i)) continue;
      const std::int32_t across = space.triangles[t].neighbour[i];
      const auto back = side_towards(space.triangles[across], static_cast<std::int32_t>(t));
      twin_[side] = 3 * across + static_cast<std::int32_t>(back);
    }
  }
}

namespace {

constexpr std::size_t kLengthClasses = 256;

// The exponent of the squared length and its next two bits: lengths of one class differ by an
// eighth at most.
std::size_t length_class(GridPoint a, GridPoint b) {
  const auto squared = static_cast<std::uint64_t>(squared_distance(a, b));
  const int width = static_cast<int>(std::bit_width(squared));
  const std::uint64_t next_bits = width > 2 ? squared >> static_cast<unsigned>(width - 3) & 3U : 0;
  return 4 * static_cast<std::size_t>(width) + next_bits;
}

}  // namespace

void SideRings::merge() {
  std::array<std::vector<std::uint32_t>, kLengthClasses> by_length;
  for (std::uint32_t side = 0; side < side_count(); ++side) {
    if (twin_[side] <= static_cast<std::int32_t>(side)) continue;
    const GridPoint end = start_point(static_cast<std::uint32_t>(twin_[side]));
    by_length[length_class(start_point(side), end)].push_back(side);
  }
  for (auto sides = by_length.rbegin(); sides != by_length.rend(); ++sides) {
    for (const std::uint32_t side : *sides) {
      if (stays_convex_without(side)) take_away(side);
    }
  }
}

bool SideRings::stays_convex_without(std::uint32_t side) const {
  const auto back = static_cast<std::uint32_t>(twin_[side]);
  // Two straight angles make a full one: a wall ends in the cell then.
  const auto is_convex = [&](std::uint32_t before, std::uint32_t at, std::uint32_t after) {
    const GridPoint p = start_point(before), q = start_point(at), r = start_point(after);
    const std::int64_t turn = orient(p, q, r);
    return turn > 0 || (turn == 0 && dot_from(q, p, r) < 0);
  };
  return is_convex(previous_[side], side, next_[next_[back]]) &&
         is_convex(previous_[back], back, next_[next_[side]]);
}

void SideRings::take_away(std::uint32_t side) {
  const auto back = static_cast<std::uint32_t>(twin_[side]);
  const auto connect = [&](std::uint32_t from, std::uint32_t to) {
    next_[from] = to;
    previous_[to] = from;
  };
  connect(previous_[side], next_[back]);
  connect(previous_[back], next_[side]);
  exists_[side] = exists_[back] = 0;
}

// A free angle at a vertex runs from a wall to a wall, over cells joined by twins. It is summed up
// from a side that starts at the vertex and is a wall, turning counter-clockwise.
bool SideRings::is_wider_than_straight(std::uint32_t first_side) const {
  const GridPoint apex = start_point(first_side);
  const GridPoint first = start_point(next_[first_side]);
  for (std::uint32_t side = first_side;;) {
    const std::uint32_t inward = previous_[side];
    const GridPoint reached = start_point(inward);
    const std::int64_t turned = orient(apex, first, reached);
    if (turned < 0 || (turned == 0 && dot_from(apex, first, reached) > 0)) return true;
    if (twin_[inward] < 0) return false;
    side = static_cast<std::uint32_t>(twin_[inward]);
  }
}

std::vector<char> SideRings::turning_vertices() const {
  std::vector<char> turning(space_.work.vertices.size());
  for (std::uint32_t side = 0; side < side_count(); ++side) {
    if (!exists(side) || twin_[side] >= 0 || turning[start(side)] != 0) continue;
    if (is_wider_than_straight(side)) turning[start(side)] = 1;
  }
  return turning;
}

}  // namespace mapwright::navcore::exact
