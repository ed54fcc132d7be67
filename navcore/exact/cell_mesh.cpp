#include "navcore/exact/cell_mesh.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "navcore/exact/side_ring.hpp"

namespace mapwright::navcore::exact {
namespace {

constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();

}  // namespace

CellMesh::CellMesh(const Tessellation& space) {
  SideRings rings(space);
  rings.merge();
  can_turn_ = rings.turning_vertices();
  std::vector<std::uint32_t> corner_of_side(rings.side_count(), kUnnumbered);
  std::vector<std::uint32_t> side_of_corner;
  for (std::uint32_t first = 0; first < rings.side_count(); ++first) {
    if (!rings.exists(first) || corner_of_side[first] != kUnnumbered) continue;
    const auto cell = static_cast<std::uint32_t>(first_corner_.size());
    first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));
    std::uint32_t side = first;
    do {
      corner_of_side[side] = static_cast<std::uint32_t>(corners_.size());
      corners_.push_back({rings.start_point(side), rings.start(side), -1});
      cell_of_corner_.push_back(cell);
      side_of_corner.push_back(side);
      side = rings.next(side);
    } while (side != first);
  }
  first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const std::int32_t twin = rings.twin(side_of_corner[i]);
    if (twin >= 0) corners_[i].twin = static_cast<std::int32_t>(corner_of_side[twin]);
  }
  find_pockets();
  find_components();
}

bool CellMesh::contains(std::uint32_t cell, GridPoint p) const {
  const std::uint32_t first = first_corner(cell), end = end_corner(cell);
  GridPoint from = corners_[end - 1].point;
  for (std::uint32_t i = first; i < end; ++i) {
    if (orient(from, corners_[i].point, p) < 0) return false;
    from = corners_[i].point;
  }
  return true;
}

bool CellMesh::is_on_wall(std::uint32_t cell, GridPoint p) const {
  const std::uint32_t first = first_corner(cell), end = end_corner(cell);
  for (std::uint32_t i = first; i < end; ++i) {
    const GridPoint from = corners_[i].point, to = corners_[i + 1 < end ? i + 1 : first].point;
    if (corners_[i].twin < 0 && is_on_segment(p, from, to)) return true;
  }
  return false;
}

// Takes away cells with a single open side again and again.
void CellMesh::find_pockets() {
  std::vector<std::uint32_t> open_sides(cell_count());
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    if (corners_[i].twin >= 0) ++open_sides[cell_of_corner_[i]];
  }
  way_out_.resize(cell_count());
  std::iota(way_out_.begin(), way_out_.end(), 0U);
  std::vector<std::uint32_t> dead_ends;
  for (std::uint32_t cell = 0; cell < cell_count(); ++cell) {
    if (open_sides[cell] == 1) dead_ends.push_back(cell);
  }
  while (!dead_ends.empty()) {
    const std::uint32_t cell = dead_ends.back();
    dead_ends.pop_back();
    for (std::uint32_t i = first_corner(cell); i < end_corner(cell); ++i) {
      if (corners_[i].twin < 0) continue;
      const std::uint32_t across = cell_of(corners_[i].twin);
      if (way_out_[across] == cell || open_sides[across] == 0) continue;
      way_out_[cell] = across;
      if (--open_sides[across] == 1) dead_ends.push_back(across);
    }
    open_sides[cell] = 0;
  }
}

double CellMesh::area_m2(std::uint32_t cell) const {
  double twice_mm2 = 0.0;
  const GridPoint apex = corners_[first_corner(cell)].point;
  for (std::uint32_t i = first_corner(cell) + 1; i + 1 < end_corner(cell); ++i) {
    twice_mm2 += static_cast<double>(orient(apex, corners_[i].point, corners_[i + 1].point));
  }
  return 0.5e-6 * twice_mm2;
}

double CellMesh::area_m2() const {
  return std::accumulate(component_area_m2_.begin(), component_area_m2_.end(), 0.0);
}

void CellMesh::find_components() {
  component_.assign(cell_count(), kUnnumbered);
  for (std::uint32_t seed = 0; seed < cell_count(); ++seed) {
    if (component_[seed] == kUnnumbered) component_area_m2_.push_back(number_component(seed));
  }
  rank_components();
}

// Gives the next number to all cells that can be reached from the seed; returns their area.
double CellMesh::number_component(std::uint32_t seed) {
  const auto number = static_cast<std::uint32_t>(component_area_m2_.size());
  double sum_m2 = 0.0;
  std::vector<std::uint32_t> waiting{seed};
  component_[seed] = number;
  while (!waiting.empty()) {
    const std::uint32_t cell = waiting.back();
    waiting.pop_back();
    sum_m2 += area_m2(cell);
    for (std::uint32_t i = first_corner(cell); i < end_corner(cell); ++i) {
      if (corners_[i].twin < 0) continue;
      const std::uint32_t across = cell_of(corners_[i].twin);
      if (component_[across] != kUnnumbered) continue;
      component_[across] = number;
      waiting.push_back(across);
    }
  }
  return sum_m2;
}

// Renumbers the components by area.
void CellMesh::rank_components() {
  std::vector<std::uint32_t> order(component_area_m2_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) {
    return component_area_m2_[p] > component_area_m2_[q];
  });
  std::vector<std::uint32_t> rank(order.size());
  std::vector<double> areas_m2;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = i;
    areas_m2.push_back(component_area_m2_[order[i]]);
  }
  for (auto& number : component_) number = rank[number];
  component_area_m2_ = std::move(areas_m2);
}

}  // namespace mapwright::navcore::exact
