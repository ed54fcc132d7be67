#include "navcore/exact/wall_passing.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::navcore {
namespace {

bool is_same_direction(Point v, Point p, Point q) {
  return turn(v, p, q) == Turn::kStraight && dot(p - v, q - v) > 0.0;
}

bool is_on(Point p, const BlockingSegment& wall) {
  const bool is_beside = p.x < std::min(wall.a.x, wall.b.x) || p.x > std::max(wall.a.x, wall.b.x) ||
                         p.y < std::min(wall.a.y, wall.b.y) || p.y > std::max(wall.a.y, wall.b.y);
  return !is_beside && meet(p, p, wall.a, wall.b).kind != Meeting::kNone;
}

// The walls around a point, as points towards which they run, counter-clockwise. Sector i lies
// between ray i and the next.
class Sectors {
 public:
  Sectors(Point centre, std::span<const BlockingSegment> walls) : centre_(centre) {
    for (const auto& wall : walls) {
      if (!is_on(centre, wall)) continue;
      for (const Point end : {wall.a, wall.b}) {
        if (end != centre) add(end);
      }
    }
    std::sort(rays_.begin(), rays_.end(), [&](Point p, Point q) { return comes_before(p, q); });
  }

  std::size_t count() const { return rays_.size(); }
  std::size_t before(std::size_t i) const { return (i + rays_.size() - 1) % rays_.size(); }

  // The last ray that is not behind p.
  std::size_t ray_at(Point p) const {
    std::size_t i = 0;
    while (i + 1 < rays_.size() && !comes_before(p, rays_[i + 1])) ++i;
    return i;
  }
  bool is_on_ray(Point p, std::size_t i) const { return is_same_direction(centre_, rays_[i], p); }

 private:
  void add(Point end) {
    const bool is_known = std::any_of(rays_.begin(), rays_.end(), [&](Point ray) {
      return is_same_direction(centre_, ray, end);
    });
    if (!is_known) rays_.push_back(end);
    if (rays_.size() == 1) first_ = rays_[0];
  }

  // Counted from the first ray found: 0 for less than half a turn.
  int half(Point p) const {
    const Turn side = turn(centre_, first_, p);
    return side == Turn::kLeft || is_same_direction(centre_, first_, p) ? 0 : 1;
  }
  bool comes_before(Point p, Point q) const {
    const int half_p = half(p), half_q = half(q);
    return half_p != half_q ? half_p < half_q : turn(centre_, p, q) == Turn::kLeft;
  }

  Point centre_;
  Point first_;
  std::vector<Point> rays_;
};

// The border is a wall where others touch it.
std::vector<BlockingSegment> with_border(std::span<const BlockingSegment> segments,
                                         const Border& border) {
  std::vector<BlockingSegment> walls(segments.begin(), segments.end());
  const Point corners[] = {{border.left, border.bottom},
                           {border.right, border.bottom},
                           {border.right, border.top},
                           {border.left, border.top}};
  for (std::size_t i = 0; i < 4; ++i) walls.push_back({corners[i], corners[(i + 1) % 4]});
  return walls;
}

// A point beyond the border, straight out from a point on it; nothing for a point within.
std::optional<Point> beyond(const Border& border, Point p) {
  const Point out{(p.x == border.right ? 1.0 : 0.0) - (p.x == border.left ? 1.0 : 0.0),
                  (p.y == border.top ? 1.0 : 0.0) - (p.y == border.bottom ? 1.0 : 0.0)};
  if (out == Point{}) return std::nullopt;
  return p + out;
}

// Walks along the path and remembers, while it runs along a wall, on which side it can be.
class Walk {
 public:
  Walk(const Border& border, std::span<const BlockingSegment> walls)
      : border_(border), walls_(walls) {}

  // From `from` over `at` towards `to`; false if that passes a wall. `is_start`: nothing comes
  // before `at`.
  bool step(Point from, Point at, Point to, bool is_start) {
    const Sectors sectors(at, walls_);
    const std::size_t n = sectors.count();
    if (n == 0) return true;
    std::vector<char> open(n, is_start ? 1 : 0);
    if (!is_start) arrive(sectors, from, open);
    if (const auto outside = beyond(border_, at)) open[sectors.ray_at(*outside)] = 0;
    return leave(sectors, to, open);
  }

 private:
  // Against the ray's direction, its left is the walker's right.
  void arrive(const Sectors& sectors, Point from, std::vector<char>& open) const {
    const std::size_t ray = sectors.ray_at(from);
    if (!sectors.is_on_ray(from, ray)) {
      open[ray] = 1;
      return;
    }
    if (can_be_right_) open[ray] = 1;
    if (can_be_left_) open[sectors.before(ray)] = 1;
  }

  bool leave(const Sectors& sectors, Point to, const std::vector<char>& open) {
    const std::size_t ray = sectors.ray_at(to);
    if (!sectors.is_on_ray(to, ray)) {
      can_be_left_ = can_be_right_ = true;
      return open[ray] != 0;
    }
    can_be_left_ = open[ray] != 0;
    can_be_right_ = open[sectors.before(ray)] != 0;
    return can_be_left_ || can_be_right_;
  }

  const Border& border_;
  std::span<const BlockingSegment> walls_;
  bool can_be_left_ = true, can_be_right_ = true;
};

// The path's points and, between them, the ends of walls that lie on it; none twice in a row.
std::vector<Point> with_touched_ends(std::span<const BlockingSegment> walls,
                                     std::span<const Point> path) {
  std::vector<Point> points{path[0]};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const BlockingSegment leg{path[i - 1], path[i]};
    std::vector<Point> on{leg.b};
    for (const auto& wall : walls) {
      for (const Point end : {wall.a, wall.b}) {
        if (end != leg.a && is_on(end, leg)) on.push_back(end);
      }
    }
    std::sort(on.begin(), on.end(), [&](Point p, Point q) {
      return squared_length(p - leg.a) < squared_length(q - leg.a);
    });
    for (const Point p : on) {
      if (p != points.back()) points.push_back(p);
    }
  }
  return points;
}

}  // namespace

bool passes_where_it_touches(const Border& border, std::span<const BlockingSegment> segments,
                             std::span<const Point> path) {
  if (path.empty()) return false;
  const std::vector<BlockingSegment> walls = with_border(segments, border);
  const std::vector<Point> points = with_touched_ends(walls, path);
  Walk walk(border, walls);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point from = points[i == 0 ? 0 : i - 1];
    if (!walk.step(from, points[i], points[i + 1], i == 0)) return true;
  }
  return false;
}

}  // namespace mapwright::navcore
