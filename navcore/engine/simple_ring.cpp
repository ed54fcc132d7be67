#include "navcore/engine/simple_ring.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::navcore::engine {
namespace {

constexpr std::size_t kMostVertices = 2000;

// Nearer than this (metres) is too near to tell in double precision without thinking.
constexpr double kClear_m = 1e-9;

struct Edge {
  Point a, b;
};

bool boxes_part(const Edge& e, const Edge& f) {
  return std::max(e.a.x, e.b.x) < std::min(f.a.x, f.b.x) ||
         std::max(f.a.x, f.b.x) < std::min(e.a.x, e.b.x) ||
         std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) ||
         std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y);
}

// True if both ends of f lie on the same side of e's line, clear of it.
bool on_one_side(const Edge& e, const Edge& f) {
  const Point along = e.b - e.a;
  const double clear = kClear_m * length(along);
  const double a = cross(along, f.a - e.a);
  const double b = cross(along, f.b - e.a);
  return (a > clear && b > clear) || (a < -clear && b < -clear);
}

bool keep_clear(const Edge& e, const Edge& f) {
  return boxes_part(e, f) || on_one_side(e, f) || on_one_side(f, e);
}

// e.b == f.a: they meet there only, unless f runs back along e.
bool join_cleanly(const Edge& e, const Edge& f) {
  const Point u = e.b - e.a;
  const Point v = f.b - f.a;
  return dot(u, v) > 0.0 || std::abs(cross(u, v)) > kClear_m * (length(u) + length(v));
}

bool is_clearly_simple(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  const auto edge = [&](std::size_t i) { return Edge{ring[i], ring[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i) {
    if (!join_cleanly(edge(i), edge((i + 1) % n))) return false;
    const std::size_t last = i == 0 ? n - 1 : n;  // edge n − 1 joins edge 0
    for (std::size_t j = i + 2; j < last; ++j) {
      if (!keep_clear(edge(i), edge(j))) return false;
    }
  }
  return true;
}

double twice_signed_area(std::span<const Point> ring) {
  double area = 0.0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    area += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  }
  return area;
}

}  // namespace

RingShape ring_shape(std::span<const Point> ring) {
  if (ring.size() < 3 || ring.size() > kMostVertices) return RingShape::kUnclear;
  const double area = twice_signed_area(ring);
  if (!(std::abs(area) > kClear_m) || !is_clearly_simple(ring)) return RingShape::kUnclear;
  return area > 0.0 ? RingShape::kCounterClockwise : RingShape::kClockwise;
}

}  // namespace mapwright::navcore::engine
