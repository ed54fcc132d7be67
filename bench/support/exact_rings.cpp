#include "bench/support/exact_rings.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <vector>

namespace mapwright::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;
using Edge = Kernel::Segment_2;

std::vector<Edge> edges_of(std::span<const Point> ring) {
  std::vector<ExactPoint> points;
  points.reserve(ring.size());
  for (const Point p : ring) points.emplace_back(p.x, p.y);
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    edges.emplace_back(points[i], points[i + 1 == points.size() ? 0 : i + 1]);
  }
  return edges;
}

// Neighbours share an end: anything beyond that point is a defect.
bool share_their_end_only(const Edge& edge, const Edge& next) {
  const auto common = CGAL::intersection(edge, next);
  return common && boost::get<ExactPoint>(&*common) != nullptr;
}

bool is_sound_pair(const std::vector<Edge>& edges, std::size_t i, std::size_t j) {
  if (j == i + 1) return share_their_end_only(edges[i], edges[j]);
  if (i == 0 && j + 1 == edges.size()) return share_their_end_only(edges[j], edges[i]);
  return !CGAL::do_intersect(edges[i], edges[j]);
}

}  // namespace

bool is_simple_exactly(std::span<const Point> ring) {
  const auto edges = edges_of(ring);
  for (const Edge& edge : edges) {
    if (edge.is_degenerate()) return false;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (!is_sound_pair(edges, i, j)) return false;
    }
  }
  return true;
}

}  // namespace mapwright::bench
