#include "navcore/reachability/reachability_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <map>
#include <unordered_set>

#include "navcore/reachability/subdivision.hpp"

namespace mapwright::navcore {
namespace {

constexpr double kFinestDefault_m = 0.05;
constexpr double kCellsAcross = 2000.0;

// How many undecided cells around a point are searched for a free one in its sight.
constexpr std::size_t kAnchorSearch = 400;

double chosen_resolution_m(const Border& border, const ReachabilityOptions& options) {
  if (options.resolution_m > 0.0) return options.resolution_m;
  const Box box = border.box();
  return std::max(kFinestDefault_m, std::max(box.width(), box.height()) / kCellsAcross);
}

// For a point robot, or one as small as the cells, no cell on a wall is ever proved blocked:
// splitting more is vain.
double chosen_finest_m(const ReachabilityOptions& options, double resolution_m) {
  return options.radius_m > options.finest_m ? std::min(options.finest_m, resolution_m)
                                             : resolution_m;
}

// An area that has no extent holds nothing.
Box usable_box(const Border& border) {
  const Box box = border.box();
  const bool usable = box.width() > 0.0 && box.height() > 0.0 && std::isfinite(box.width()) &&
                      std::isfinite(box.height());
  return usable ? box : Box{0.0, 0.0, 0.0, 0.0};
}

}  // namespace

ReachabilityMap::ReachabilityMap(const FreeSpace& space, const ReachabilityOptions& options)
    : space_(&space),
      radius_m_(options.radius_m),
      resolution_m_(chosen_resolution_m(space.border(), options)),
      tree_(usable_box(space.border()), chosen_finest_m(options, resolution_m_)) {
  assert(options.radius_m >= 0.0);
  Subdivision subdivision(space, radius_m_, options.max_cells, tree_);
  subdivision.split_to(resolution_m_);
  label();
  subdivision.decide_connections(sure_);
  label();
  list_areas();
  std::erase_if(areas_, [&](const ReachableArea& a) { return a.area_m2 < options.min_area_m2; });
  area_groups_.resize(areas_.size());
}

void ReachabilityMap::label() {
  sure_ = UnionFind(tree_.size());
  possible_ = UnionFind(tree_.size());
  for (CellTree::Cell cell = 0; cell < tree_.size(); ++cell) {
    const Passage passage = tree_.passage(cell);
    if (!tree_.is_leaf(cell) || passage == Passage::kBlocked) continue;
    tree_.for_each_larger_neighbour(cell, [&](CellTree::Cell beside) {
      const Passage other = tree_.passage(beside);
      if (other == Passage::kBlocked) return;
      possible_.unite(cell, beside);
      if (passage == Passage::kFree && other == Passage::kFree) sure_.unite(cell, beside);
    });
  }
}

void ReachabilityMap::list_areas() {
  struct Found {
    ReachableArea area;
    CellTree::Cell largest = CellTree::kNone;
    std::uint32_t sure = CellTree::kNone;
  };
  std::map<std::uint32_t, Found> found;  // by representative, so in a settled order
  for (CellTree::Cell cell = 0; cell < tree_.size(); ++cell) {
    if (!tree_.is_leaf(cell) || tree_.passage(cell) == Passage::kBlocked) continue;
    if (tree_.passage(cell) == Passage::kUndecided) {
      undecided_area_m2_ += tree_.area_m2(cell);
      continue;
    }
    auto& [area, largest, sure] = found[possible_.find(cell)];
    const std::uint32_t own = sure_.find(cell);
    if (largest == CellTree::kNone) {
      area.box = kEmptyBox;
      area.is_connected = true;
      sure = own;
    }
    if (largest == CellTree::kNone || tree_.side_m(cell) > tree_.side_m(largest)) largest = cell;
    area.is_connected = area.is_connected && own == sure;
    area.area_m2 += tree_.area_m2(cell);
    const Box box = tree_.box(cell);
    area.box.add({box.min_x, box.min_y});
    area.box.add({box.max_x, box.max_y});
    area.at = tree_.center(largest);
  }
  std::vector<std::pair<std::uint32_t, ReachableArea>> sorted;
  for (auto& [group, entry] : found) sorted.emplace_back(group, entry.area);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& p, const auto& q) {
    return p.second.area_m2 > q.second.area_m2;
  });
  for (const auto& [group, area] : sorted) {
    free_area_m2_ += area.area_m2;
    areas_.push_back(area);
    area_groups_.push_back(group);
  }
}

double ReachabilityMap::largest_fraction() const {
  return areas_.empty() ? 0.0 : areas_.front().area_m2 / free_area_m2_;
}

// Looks around a point in an undecided cell, breadth first through undecided cells.
std::uint32_t ReachabilityMap::free_cell_in_sight(Point p, CellTree::Cell from) const {
  std::unordered_set<CellTree::Cell> seen{from};
  std::deque<CellTree::Cell> queue{from};
  CellTree::Cell found = CellTree::kNone;
  for (; !queue.empty() && found == CellTree::kNone && seen.size() < kAnchorSearch;
       queue.pop_front()) {
    tree_.for_each_neighbour(queue.front(), [&](CellTree::Cell beside) {
      if (tree_.passage(beside) == Passage::kBlocked || !seen.insert(beside).second) return;
      if (tree_.passage(beside) == Passage::kUndecided) {
        queue.push_back(beside);
      } else if (found == CellTree::kNone &&
                 space_->is_free_way(p, tree_.center(beside), radius_m_)) {
        found = beside;
      }
    });
  }
  return found;
}

ReachabilityMap::Anchor ReachabilityMap::anchor(Point p) const {
  const CellTree::Cell leaf = tree_.leaf_at(p);
  if (leaf == CellTree::kNone || tree_.passage(leaf) == Passage::kBlocked) return {};
  const CellTree::Cell free =
      tree_.passage(leaf) == Passage::kFree ? leaf : free_cell_in_sight(p, leaf);
  if (free == CellTree::kNone) return {possible_.find(leaf), CellTree::kNone};
  return {possible_.find(free), sure_.find(free)};
}

Connection ReachabilityMap::connected(Point a, Point b) const {
  if (!space_->is_free(a, radius_m_) || !space_->is_free(b, radius_m_)) return Connection::kNo;
  if (space_->is_free_way(a, b, radius_m_)) return Connection::kYes;
  const Anchor first = anchor(a);
  const Anchor second = anchor(b);
  if (first.possible == CellTree::kNone || second.possible == CellTree::kNone) {
    return Connection::kUndecided;
  }
  if (first.possible != second.possible) return Connection::kNo;
  const bool sure = first.sure != CellTree::kNone && first.sure == second.sure;
  return sure ? Connection::kYes : Connection::kUndecided;
}

std::optional<std::size_t> ReachabilityMap::area_at(Point p) const {
  if (!space_->is_free(p, radius_m_)) return std::nullopt;
  const Anchor place = anchor(p);
  if (place.sure == CellTree::kNone) return std::nullopt;
  const auto found = std::find(area_groups_.begin(), area_groups_.end(), place.possible);
  if (found == area_groups_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - area_groups_.begin());
}

}  // namespace mapwright::navcore
