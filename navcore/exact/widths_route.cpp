// Routes along the medial axis, with as much room as there is.
#include <cmath>
#include <limits>

#include "navcore/exact/gap.hpp"
#include "navcore/exact/widths.hpp"

namespace mapwright::navcore::exact {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

Point to_point(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

// Points as near to a point as to a line.
class Parabola {
 public:
  Parabola(GridPoint focus, const VoronoiSite& line)
      : axis_foot_(foot_on_line(to_point(focus), line)) {
    const Point d = to_point(line.b) - to_point(line.a);
    direction_ = (1.0 / length(d)) * d;
    const double signed_mm = static_cast<double>(orient(line.a, line.b, focus)) / length(d);
    normal_ = (signed_mm < 0.0 ? -1.0 : 1.0) * Point{-direction_.y, direction_.x};
    half_mm_ = 0.5 * std::abs(signed_mm);
  }

  double along(Point p) const { return dot(p - axis_foot_, direction_); }
  bool is_curved() const { return half_mm_ > 0.0; }
  Point apex() const { return axis_foot_ + half_mm_ * normal_; }

  // Where the tangents at s and t meet. The way from the one over this point to the other stays on
  // the line's side, above the stretch between s and t.
  Point meeting_of_tangents(double s, double t) const {
    const double height_mm = half_mm_ + s * t / (4.0 * half_mm_);
    return axis_foot_ + 0.5 * (s + t) * direction_ + height_mm * normal_;
  }

 private:
  Point axis_foot_, direction_, normal_;
  double half_mm_ = 0.0;
};

// From p to q, both on the parabola, p left out. The line stays the nearest site, and the way is
// nowhere nearer to it than the curve is somewhere between p and q.
void follow(const Parabola& parabola, Point p, Point q, std::vector<Point>& points) {
  double s = parabola.along(p);
  const double t = parabola.along(q);
  if (s * t < 0.0) {  // the narrowest place lies between
    points.push_back(parabola.meeting_of_tangents(s, 0.0));
    points.push_back(parabola.apex());
    s = 0.0;
  }
  points.push_back(parabola.meeting_of_tangents(s, t));
  points.push_back(q);
}

}  // namespace

// Along an edge of the medial axis between two of its points.
void Widths::follow_edge(const VoronoiEdge& edge, Point p, Point q,
                         std::vector<Point>& points) const {
  const VoronoiSite &first = graph_.sites[edge.first_site],
                    &second = graph_.sites[edge.second_site];
  if (first.is_point() != second.is_point()) {
    const Parabola parabola(first.is_point() ? first.a : second.a,
                            first.is_point() ? second : first);
    if (parabola.is_curved()) return follow(parabola, p, q, points);
  }
  points.push_back(q);
}

// The vertex below which v lies when all edges wider than the one at `rank` have been joined.
std::uint32_t Widths::top_before(std::uint32_t v, std::uint32_t rank) const {
  while (links_[v].parent != v && links_[v].rank < rank) v = links_[v].parent;
  return v;
}

// The forest's way between two of its vertices is found from its narrowest edge outwards.
void Widths::follow_forest(std::uint32_t from, std::uint32_t to, std::vector<Point>& points) const {
  struct Task {
    std::uint32_t from, to;  // vertices; for an edge, its number and the vertex it leads to
    bool is_edge;
  };
  std::vector<Task> tasks{{from, to, false}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    if (task.is_edge) {
      follow_edge(graph_.edges[task.from], points.back(), graph_.vertices[task.to], points);
      continue;
    }
    const auto rank = narrowest_between(task.from, task.to);
    if (!rank || *rank == kNone) continue;
    const VoronoiEdge& edge = graph_.edges[order_[*rank]];
    const bool forward = top_before(edge.from, *rank) == top_before(task.from, *rank);
    const std::uint32_t near = forward ? edge.from : edge.to, far = forward ? edge.to : edge.from;
    tasks.push_back({far, task.to, false});
    tasks.push_back({order_[*rank], far, true});
    tasks.push_back({task.from, near, false});
  }
}

std::vector<SiteRound> Widths::rounds_around(const Tessellation& space, GridPoint p,
                                             double diameter_mm) const {
  const auto vertex = region_of(p, diameter_mm);
  if (!vertex) return {};
  return exact::rounds_around(space, static_cast<std::uint32_t>(*vertex), [&](std::uint32_t edge) {
    return is_wide_enough(passages_[edge].width_mm, diameter_mm);
  });
}

std::vector<Point> Widths::widest_route(GridPoint a, GridPoint b) const {
  const auto foot_a = foot_of(a), foot_b = foot_of(b);
  if (!foot_a || !foot_b) return {};
  const Way way = between(*foot_a, *foot_b);
  if (!(way.narrowest.width_mm > 0.0)) return {};
  std::vector<Point> points{to_point(a), foot_a->at};
  const VoronoiEdge &edge_a = graph_.edges[foot_a->edge], &edge_b = graph_.edges[foot_b->edge];
  if (way.first_vertex == kNone) {
    follow_edge(edge_a, foot_a->at, foot_b->at, points);
  } else {
    follow_edge(edge_a, foot_a->at, graph_.vertices[way.first_vertex], points);
    follow_forest(way.first_vertex, way.last_vertex, points);
    follow_edge(edge_b, points.back(), foot_b->at, points);
  }
  points.push_back(to_point(b));
  return points;
}

}  // namespace mapwright::navcore::exact
