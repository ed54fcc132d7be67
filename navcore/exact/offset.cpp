#include "navcore/exact/offset.hpp"

#include <algorithm>
#include <numbers>

#include "navcore/exact/boundary.hpp"

namespace mapwright::navcore::exact {
namespace {

// Rounding the corners of the moved walls to the grid, and cutting them where they cross.
constexpr double kRounding_mm = 0.72;

// A side of the boundary, moved.
struct Course {
  Point from, to;   // mm, where the wall is
  Point direction;  // unit
  double length_mm;
  Point left() const { return {-direction.y, direction.x}; }
};

class CycleOffset {
 public:
  CycleOffset(const Tessellation& base, double radius_mm, int tangents_a_quadrant)
      : base_(base),
        radius_mm_(radius_mm),
        step_rad_(0.5 * std::numbers::pi / tangents_a_quadrant) {}

  // Adds the closed curve that runs beside the cycle, on its free side.
  void trace(const BoundaryCycle& cycle, std::vector<Line>& lines) {
    lines_ = &lines;
    const std::size_t n = cycle.size();
    for (std::size_t i = 0; i < n; ++i) {
      // Cutting every corner of a ring short would leave a gap where all its strips overlap.
      may_shorten_ = i > 0;
      turn(course(cycle[i]), course(cycle[(i + 1) % n]), cycle[i].edge);
    }
    if (has_last_) add(first_point_, cycle[0].edge);
    has_last_ = false;
  }

 private:
  Course course(const BoundarySide& side) const {
    const GridPoint a = base_.work.vertices[side.from], b = base_.work.vertices[side.to];
    const Point from{static_cast<double>(a.x), static_cast<double>(a.y)};
    const Point to{static_cast<double>(b.x), static_cast<double>(b.y)};
    const double length_mm = length(to - from);
    return {from, to, (1.0 / length_mm) * (to - from), length_mm};
  }

  // The corner between two courses: what is added leads from the end of the one to the start of
  // the other.
  void turn(const Course& in, const Course& out, std::uint32_t edge) {
    const double sine = cross(in.direction, out.direction);
    const double cosine = dot(in.direction, out.direction);
    if (sine <= 0.0 && (sine < 0.0 || cosine < 0.0)) {
      go_around(in, std::atan2(-sine, cosine), edge);
    } else {
      turn_inward(in, out, sine, cosine, edge);
    }
  }

  // A convex corner of the obstacle: tangents to the circle around it, clockwise by `angle`.
  void go_around(const Course& in, double angle_rad, std::uint32_t edge) {
    const double angle = std::abs(angle_rad);
    const auto count = static_cast<int>(std::max(1.0, std::ceil(angle / step_rad_ - 1e-9)));
    const double half = 0.5 * angle / count;
    const double reach_mm = radius_mm_ / std::cos(half);
    const Point n = in.left();
    for (int i = 0; i < count; ++i) {
      const double c = std::cos((2 * i + 1) * half), s = std::sin((2 * i + 1) * half);
      add(in.to + reach_mm * Point{c * n.x + s * n.y, c * n.y - s * n.x}, edge);
    }
  }

  // A corner of the free space: the moved walls meet before it, if both are long enough; otherwise
  // the curve runs over the corner itself, which leaves the strips beside both walls blocked
  // whatever they overlap.
  void turn_inward(const Course& in, const Course& out, double sine, double cosine,
                   std::uint32_t edge) {
    const double tangent_of_half = sine / (1.0 + cosine);
    const double needed_mm = radius_mm_ * std::max(1.0, tangent_of_half);
    if (may_shorten_ && cosine > -0.5 && std::min(in.length_mm, out.length_mm) >= needed_mm) {
      add(in.to + (radius_mm_ / (1.0 + cosine)) * (in.left() + out.left()), edge);
      return;
    }
    add(in.to + radius_mm_ * in.left(), edge);
    add(in.to, edge);
    add(out.from + radius_mm_ * out.left(), edge);
  }

  void add(Point p, std::uint32_t edge) {
    const GridPoint q{static_cast<std::int32_t>(std::nearbyint(p.x)),
                      static_cast<std::int32_t>(std::nearbyint(p.y))};
    add(q, edge);
  }

  void add(GridPoint q, std::uint32_t edge) {
    if (has_last_) {
      lines_->push_back({last_, q, edge});
    } else {
      first_point_ = q;
    }
    last_ = q;
    has_last_ = true;
  }

  const Tessellation& base_;
  double radius_mm_;
  double step_rad_;
  std::vector<Line>* lines_ = nullptr;
  bool may_shorten_ = false;
  bool has_last_ = false;
  GridPoint last_, first_point_;
};

std::vector<Line> moved_walls(const Tessellation& base, double radius_mm, int tangents) {
  std::vector<Line> lines;
  CycleOffset offset(base, radius_mm, tangents);
  for (const BoundaryCycle& cycle : boundary_cycles(base)) offset.trace(cycle, lines);
  return lines;
}

// How often the curves wind around what is left of the edge (a→b) more than around its right.
int winding_step(const LineWork& work, const Edge& edge) {
  int step = 0;
  for (std::uint32_t i = edge.first_piece; i < edge.last_piece; ++i) {
    step += work.pieces[i].reversed ? -1 : 1;
  }
  return step;
}

// What the winding number grows by from the triangle's inside across its side i.
int step_across(const Tessellation& space, std::uint32_t t, std::size_t i) {
  const Triangle& triangle = space.triangles[t];
  if (triangle.edge[i] < 0) return 0;
  const Edge& edge = space.work.edges[static_cast<std::size_t>(triangle.edge[i])];
  const int left_of_edge = winding_step(space.work, edge);
  return triangle.corner[i] == edge.a ? -left_of_edge : left_of_edge;
}

// Winding numbers of the moved walls around each triangle, from the hull inwards.
std::vector<int> winding_numbers(const Tessellation& space) {
  constexpr int kUnknown = -1'000'000;
  std::vector<int> winding(space.triangles.size(), kUnknown);
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t t = 0; t < space.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (space.triangles[t].neighbour[i] >= 0 || winding[t] != kUnknown) continue;
      winding[t] = -step_across(space, t, i);
      waiting.push_back(t);
    }
  }
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t across = space.triangles[t].neighbour[i];
      if (across < 0 || winding[across] != kUnknown) continue;
      winding[across] = winding[t] + step_across(space, t, i);
      waiting.push_back(static_cast<std::uint32_t>(across));
    }
  }
  return winding;
}

// The curves wind once around what is free of every strip beside a wall, and less often around the
// rest.
void mark_free(Tessellation& space) {
  const std::vector<int> winding = winding_numbers(space);
  space.is_free.resize(space.triangles.size());
  for (std::size_t t = 0; t < winding.size(); ++t) space.is_free[t] = winding[t] > 0;
  space.is_wall.resize(space.work.edges.size());
  for (std::size_t e = 0; e < space.is_wall.size(); ++e) {
    space.is_wall[e] = winding_step(space.work, space.work.edges[e]) != 0;
  }
}

double half_of_narrow_side_mm(const std::vector<GridPoint>& points) {
  Box box = kEmptyBox;
  for (const GridPoint p : points) box.add({static_cast<double>(p.x), static_cast<double>(p.y)});
  return points.empty() ? 0.0 : 0.5 * std::min(box.width(), box.height());
}

}  // namespace

double offset_excess(int tangents_a_quadrant) {
  return 1.0 / std::cos(0.25 * std::numbers::pi / tangents_a_quadrant);
}

Tessellation offset_free_space(const Tessellation& base, const OffsetOptions& options) {
  // A disc wider than the map fits nowhere, and larger offsets would leave the grid.
  constexpr double kMostRadius_mm = 1e8;
  if (options.radius_mm >= half_of_narrow_side_mm(base.work.vertices)) return {};
  if (options.radius_mm > kMostRadius_mm) return {};
  for (double noding_mm = kRounding_mm;;) {
    const double radius_mm = options.radius_mm + options.base_error_mm + kRounding_mm + noding_mm;
    Tessellation space;
    space.work = node(moved_walls(base, radius_mm, options.tangents_a_quadrant));
    if (space.work.displacement_mm <= noding_mm) {
      space.triangles = triangulate(space.work);
      mark_free(space);
      return space;
    }
    noding_mm = space.work.displacement_mm;  // rare: cutting once was not enough
  }
}

}  // namespace mapwright::navcore::exact
