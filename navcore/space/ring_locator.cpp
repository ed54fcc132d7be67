#include "navcore/space/ring_locator.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::navcore {
namespace {

enum class Crossing { kNone, kRight, kOn };

// Does the edge meet the ray from p along +x? An edge owns its lower end only, so that a ray
// through a vertex is counted once.
Crossing crossing(Point a, Point b, Point p) {
  if (p.x > std::max(a.x, b.x) || p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y)) {
    return Crossing::kNone;
  }
  const bool counts = (a.y > p.y) != (b.y > p.y);
  if (p.x < std::min(a.x, b.x)) return counts ? Crossing::kRight : Crossing::kNone;
  const Turn side = b.y > a.y ? turn(a, b, p) : turn(b, a, p);
  if (side == Turn::kStraight) return Crossing::kOn;
  return counts && side == Turn::kLeft ? Crossing::kRight : Crossing::kNone;
}

}  // namespace

RingLocator::RingLocator(std::span<const RingPoints> rings) {
  choose_rows(rings);
  if (row_count_ == 0) return;
  std::vector<std::vector<Run>> rows(row_count_);
  std::vector<std::vector<Edge>> row_edges(row_count_);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    add_ring(rings[i], static_cast<std::uint32_t>(i), rows, row_edges);
  }
  pack(rows, row_edges);
}

// Rows of a quarter of the edges' mean height: an edge falls into five of them on average, which
// keeps memory linear whatever the map.
void RingLocator::choose_rows(std::span<const RingPoints> rings) {
  Box box = kEmptyBox;
  double total_height = 0.0;
  std::size_t edges = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      box.add(ring[i]);
      total_height += std::abs(ring[(i + 1) % ring.size()].y - ring[i].y);
    }
    edges += ring.size();
  }
  if (edges == 0) return;
  min_y_ = box.min_y;
  max_y_ = box.max_y;
  const double most_rows = 4.0 * static_cast<double>(edges);
  const double rows = total_height > 0.0 ? most_rows * box.height() / total_height : 1.0;
  row_count_ = static_cast<std::size_t>(std::clamp(rows, 1.0, most_rows));
  row_height_ = box.height() > 0.0 ? box.height() / static_cast<double>(row_count_) : 1.0;
}

// Monotone in y, so that an edge's rows are those between the rows of its ends.
std::size_t RingLocator::row_of(double y) const {
  const auto row = static_cast<std::size_t>((y - min_y_) / row_height_);
  return std::min(row, row_count_ - 1);
}

void RingLocator::add_ring(std::span<const Point> ring, std::uint32_t number,
                           std::vector<std::vector<Run>>& rows,
                           std::vector<std::vector<Edge>>& row_edges) const {
  Box box = kEmptyBox;
  for (const Point p : ring) box.add(p);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
    const auto [low, high] = std::minmax(edge.a.y, edge.b.y);
    for (std::size_t row = row_of(low); row <= row_of(high); ++row) {
      if (rows[row].empty() || rows[row].back().ring != number) {
        rows[row].push_back({number, row_edges[row].size(), 0, box.min_x, box.max_x});
      }
      row_edges[row].push_back(edge);
      rows[row].back().last_edge = row_edges[row].size();
    }
  }
}

void RingLocator::pack(std::vector<std::vector<Run>>& rows,
                       std::vector<std::vector<Edge>>& row_edges) {
  for (std::size_t row = 0; row < row_count_; ++row) {
    first_run_.push_back(runs_.size());
    for (Run run : rows[row]) {
      run.first_edge += edges_.size();
      run.last_edge += edges_.size();
      runs_.push_back(run);
    }
    edges_.insert(edges_.end(), row_edges[row].begin(), row_edges[row].end());
  }
  first_run_.push_back(runs_.size());
}

std::vector<RingLocator::Holder> RingLocator::holders(Point p) const {
  std::vector<Holder> holders;
  if (!(min_y_ <= p.y && p.y <= max_y_)) return holders;
  const std::size_t row = row_of(p.y);
  for (std::size_t i = first_run_[row]; i < first_run_[row + 1]; ++i) {
    const Run& run = runs_[i];
    if (p.x < run.min_x || p.x > run.max_x) continue;
    bool odd = false;
    bool on_boundary = false;
    for (std::size_t e = run.first_edge; e < run.last_edge && !on_boundary; ++e) {
      const Crossing kind = crossing(edges_[e].a, edges_[e].b, p);
      odd ^= kind == Crossing::kRight;
      on_boundary = kind == Crossing::kOn;
    }
    if (odd || on_boundary) holders.push_back({run.ring, on_boundary});
  }
  return holders;
}

}  // namespace mapwright::navcore
