#include "converter/indoorgml/wall_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mapwright::converter {
namespace {

SegmentIndex index_of(const std::vector<std::pair<Point, Point>>& openings) {
  std::vector<IndexedSegment> segments;
  for (const auto& [a, b] : openings) segments.push_back({a, b, 0});
  return SegmentIndex(std::move(segments));
}

// The share of ab along which pq lies nearer than the tolerance.
std::optional<std::pair<double, double>> overlap(Point a, Point b, Point p, Point q,
                                                 double tolerance) {
  const double length_squared = squared_length(b - a);
  if (length_squared == 0.0) return std::nullopt;
  const auto along = [&](Point r) { return dot(r - a, b - a) / length_squared; };
  const auto aside = [&](Point r) { return cross(b - a, r - a) / std::sqrt(length_squared); };
  if (along(p) > along(q)) std::swap(p, q);
  const double s = along(p), t = along(q);
  const double from = std::max(0.0, s), to = std::min(1.0, t);
  if ((to - from) * std::sqrt(length_squared) <= tolerance) return std::nullopt;
  const auto aside_at = [&](double u) {
    return aside(p) + (u - s) / (t - s) * (aside(q) - aside(p));
  };
  if (std::abs(aside_at(from)) > tolerance || std::abs(aside_at(to)) > tolerance) {
    return std::nullopt;
  }
  return std::pair(from, to);
}

Box box_around(const WallEdge& edge, double margin) {
  Box box = kEmptyBox;
  box.add(edge.a);
  box.add(edge.b);
  return box.inflated(margin);
}

}  // namespace

SegmentIndex index_of(const std::vector<WallEdge>& edges) {
  std::vector<IndexedSegment> segments;
  for (const auto& edge : edges) segments.push_back({edge.a, edge.b, 0});
  return SegmentIndex(std::move(segments));
}

WallLines::WallLines(std::vector<WallEdge> edges, WallRules rules)
    : edges_(std::move(edges)),
      rules_(std::move(rules)),
      edge_index_(index_of(edges_)),
      opening_index_(index_of(rules_.openings)) {}

// Whether an edge that lies on another takes the wall from it.
bool WallLines::takes(std::size_t edge, std::size_t other) const {
  const auto &e = edges_[edge], &o = edges_[other];
  if (e.owner == o.owner) return dot(e.b - e.a, o.b - o.a) < 0.0;  // the floor goes on
  return o.owner < e.owner || rules_.are_open(e.owner, o.owner);
}

std::vector<WallLines::Span> WallLines::taken_spans(std::size_t edge) const {
  const auto& e = edges_[edge];
  const Box box = box_around(e, rules_.tolerance);
  std::vector<Span> spans;
  const auto add = [&](Point p, Point q) {
    if (const auto span = overlap(e.a, e.b, p, q, rules_.tolerance)) spans.push_back(*span);
    return true;
  };
  opening_index_.query(
      box, [&](std::size_t i) { return add(rules_.openings[i].first, rules_.openings[i].second); });
  edge_index_.query(box, [&](std::size_t i) {
    return i == edge || !takes(edge, i) || add(edges_[i].a, edges_[i].b);
  });
  std::sort(spans.begin(), spans.end());
  return spans;
}

void WallLines::append_walls(std::size_t edge, std::vector<std::vector<Point>>& lines) const {
  const auto& e = edges_[edge];
  const double least = 0.2 * rules_.tolerance;
  const auto append = [&](double from, double to) {
    if ((to - from) * distance(e.a, e.b) <= least) return;
    const Point p = from == 0.0 ? e.a : e.a + from * (e.b - e.a);
    const Point q = to == 1.0 ? e.b : e.a + to * (e.b - e.a);
    if (lines.empty() || lines.back().back() != p) lines.push_back({p});
    lines.back().push_back(q);
  };
  double done = 0.0;
  for (const auto& [from, to] : taken_spans(edge)) {
    append(done, from);
    done = std::max(done, to);
  }
  append(done, 1.0);
}

std::vector<std::vector<Point>> WallLines::of(std::size_t owner) const {
  const auto by_owner = [](const WallEdge& e, std::size_t o) { return e.owner < o; };
  auto at = std::lower_bound(edges_.begin(), edges_.end(), owner, by_owner);
  std::vector<std::vector<Point>> lines;
  for (; at != edges_.end() && at->owner == owner; ++at) {
    append_walls(static_cast<std::size_t>(at - edges_.begin()), lines);
  }
  // A ring may begin in the middle of a wall.
  if (lines.size() > 1 && lines.back().back() == lines.front().front()) {
    lines.back().insert(lines.back().end(), lines.front().begin() + 1, lines.front().end());
    lines.front() = std::move(lines.back());
    lines.pop_back();
  }
  return lines;
}

}  // namespace mapwright::converter
