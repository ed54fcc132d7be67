#include "mapcore/geometry/hausdorff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright {
namespace {

SegmentIndex index_of(const std::vector<DrawnEdge>& edges) {
  std::vector<IndexedSegment> segments;
  segments.reserve(edges.size());
  for (const DrawnEdge& edge : edges) segments.push_back({edge.a, edge.b, 0});
  return SegmentIndex(std::move(segments));
}

double distance_to(Point p, const IndexedSegment& segment) {
  return distance(p, closest_point_on_segment(p, segment.a, segment.b));
}

// Raises `bound` to what the edge needs.
class Bisection {
 public:
  Bisection(const SegmentIndex& to, double slack_m) : to_(to), slack_m_(slack_m) {}

  void raise(const DrawnEdge& edge, double& bound) const {
    std::vector<DrawnEdge> open{edge};
    while (!open.empty()) {
      const DrawnEdge e = open.back();
      open.pop_back();
      const Point middle = 0.5 * e.a + 0.5 * e.b;
      const auto nearest = to_.nearest(middle);
      const auto& other = to_[nearest->segment];
      const double most = std::max(distance_to(e.a, other), distance_to(e.b, other));
      if (most <= bound) continue;
      const double least = std::max(
          {to_.nearest(e.a)->distance_m, to_.nearest(e.b)->distance_m, nearest->distance_m});
      if (most - least <= slack_m_) {
        bound = std::max(bound, most);
        continue;
      }
      open.push_back({e.a, middle});
      open.push_back({middle, e.b});
    }
  }

 private:
  const SegmentIndex& to_;
  double slack_m_;
};

double directed(const std::vector<DrawnEdge>& from, const std::vector<DrawnEdge>& to,
                double slack_m) {
  const SegmentIndex index = index_of(to);
  const Bisection bisection(index, slack_m);
  double bound = 0.0;
  for (const DrawnEdge& edge : from) bisection.raise(edge, bound);
  return bound;
}

}  // namespace

std::vector<DrawnEdge> edges_of(std::span<const Point> points, bool closed) {
  std::vector<DrawnEdge> edges;
  const std::size_t count = points.empty() ? 0 : points.size() - (closed ? 0 : 1);
  edges.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    edges.push_back({points[i], points[i + 1 == points.size() ? 0 : i + 1]});
  }
  return edges;
}

double hausdorff_distance_m(const std::vector<DrawnEdge>& first,
                            const std::vector<DrawnEdge>& second, double slack_m) {
  if (first.empty() && second.empty()) return 0.0;
  if (first.empty() || second.empty()) return std::numeric_limits<double>::infinity();
  return std::max(directed(first, second, slack_m), directed(second, first, slack_m));
}

}  // namespace mapwright
