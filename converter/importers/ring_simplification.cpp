#include "converter/importers/ring_simplification.hpp"

#include <algorithm>
#include <cstdint>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright::converter {
namespace {

using Ring = std::vector<Point>;

constexpr int kHalvings = 4;

std::size_t farthest_from(const Ring& ring, Point p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (squared_length(ring[i] - p) > squared_length(ring[best] - p)) best = i;
  }
  return best;
}

/// Marks the vertices to keep of a ring that begins at vertex 0, which is repeated at its end.
class Keeper {
 public:
  Keeper(const Ring& closed, double bound) : closed_(closed), bound_(bound), keep_(closed.size()) {}

  Ring kept(std::size_t middle) {
    keep_[0] = keep_[middle] = true;
    work_ = {{0, middle}, {middle, closed_.size() - 1}};
    while (!work_.empty()) {
      const auto [first, last] = work_.back();
      work_.pop_back();
      split(first, last);
    }
    Ring result;
    for (std::size_t i = 0; i + 1 < closed_.size(); ++i) {
      if (keep_[i]) result.push_back(closed_[i]);
    }
    return result;
  }

 private:
  void split(std::size_t first, std::size_t last) {
    double worst = bound_;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Point foot = closest_point_on_segment(closed_[i], closed_[first], closed_[last]);
      const double off = distance(closed_[i], foot);
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    if (at == first) return;
    keep_[at] = true;
    work_.push_back({first, at});
    work_.push_back({at, last});
  }

  const Ring& closed_;
  double bound_;
  std::vector<char> keep_;
  std::vector<std::pair<std::size_t, std::size_t>> work_;
};

// From the two vertices farthest apart, nearly: corners rather than places along a wall.
Ring simplified(const Ring& ring, double bound) {
  if (ring.size() <= 3) return ring;
  Ring closed = ring;
  const std::size_t start = farthest_from(ring, ring.front());
  std::rotate(closed.begin(), closed.begin() + static_cast<std::ptrdiff_t>(start), closed.end());
  const std::size_t middle = farthest_from(closed, closed.front());
  closed.push_back(closed.front());
  while (true) {  // a sliver keeps its width
    Ring result = Keeper(closed, bound).kept(middle);
    if (result.size() >= 3) return result;
    bound *= 0.5;
  }
}

// Which rings are not simple, or have a point in common with another.
std::vector<char> colliding(const std::vector<Ring>& rings) {
  std::vector<char> result(rings.size(), 0);
  std::vector<IndexedSegment> edges;
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    if (!is_simple_ring(rings[r])) result[r] = 1;
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      edges.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()], r});
    }
  }
  const SegmentIndex index(edges);
  for (const auto& edge : edges) {
    index.query_meeting(edge.a, edge.b, [&](std::size_t other) {
      if (index[other].tag != edge.tag) result[index[other].tag] = result[edge.tag] = 1;
      return true;
    });
  }
  return result;
}

}  // namespace

std::vector<Ring> simplified_rings(const std::vector<Ring>& rings, double bound) {
  std::vector<double> bounds(rings.size(), bound);
  std::vector<Ring> result(rings.size());
  std::vector<char> again(rings.size(), 1);
  while (std::find(again.begin(), again.end(), 1) != again.end()) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      if (again[r] != 0) result[r] = simplified(rings[r], bounds[r]);
    }
    again = colliding(result);
    for (std::size_t r = 0; r < rings.size(); ++r) {
      if (again[r] == 0) continue;
      if (bounds[r] == 0.0) again[r] = 0;  // as it was: its neighbours have to give way
      bounds[r] = bounds[r] > bound * (1.0 / (1 << kHalvings)) ? 0.5 * bounds[r] : 0.0;
    }
  }
  return result;
}

}  // namespace mapwright::converter
