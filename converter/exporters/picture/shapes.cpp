#include "converter/exporters/picture/shapes.hpp"

#include <algorithm>
#include <charconv>
#include <unordered_map>

namespace mapwright::converter {
namespace {

using InnerRings = std::unordered_map<std::int64_t, std::vector<const Obstacle*>>;

std::optional<std::int64_t> outer_id(const Obstacle& obstacle) {
  const auto text = obstacle.semantic.value(semantic_key::kInnerOf);
  std::int64_t id = 0;
  if (!text || std::from_chars(text->data(), text->data() + text->size(), id).ec != std::errc{}) {
    return std::nullopt;
  }
  return id;
}

InnerRings inner_rings(const Map& map) {
  InnerRings rings;
  for (const auto& obstacle : map.obstacles) {
    if (const auto id = outer_id(obstacle)) rings[*id].push_back(&obstacle);
  }
  return rings;
}

bool meets(const Box& a, const Box& b) {
  return a.min_x <= b.max_x && b.min_x <= a.max_x && a.min_y <= b.max_y && b.min_y <= a.max_y;
}

bool is_drawable(const Obstacle& obstacle) {
  return std::all_of(
      obstacle.segments.begin(), obstacle.segments.end(),
      [](const Segment& segment) { return is_finite(segment.a) && is_finite(segment.b); });
}

std::vector<Point> outline(const Obstacle& obstacle) {
  return obstacle.shape_type == ShapeType::kStairs ? stairs_outline(obstacle)
                                                   : chain_points(obstacle);
}

Shape make_shape(const Obstacle& obstacle, const InnerRings& inner, const View& view) {
  Shape shape{&obstacle, obstacle_kind(obstacle), {view.to_page(outline(obstacle))}, kEmptyBox};
  for (const Point p : shape.rings.front()) shape.box.add(p);
  const auto holes = inner.find(obstacle.id);
  if (holes == inner.end() || outer_id(obstacle)) return shape;
  for (const auto* hole : holes->second) {
    if (is_drawable(*hole)) shape.rings.push_back(view.to_page(chain_points(*hole)));
  }
  return shape;
}

}  // namespace

std::vector<Point> stairs_outline(const Obstacle& stairs) {
  std::vector<Point> points;
  for (const auto& segment : stairs.segments) {
    points.push_back(segment.a);
    points.push_back(segment.b);
  }
  std::sort(points.begin(), points.end(),
            [](Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  // Andrew's monotone chain: the lower hull from left to right, then the upper one back.
  std::vector<Point> hull;
  const auto extend = [&hull](Point p, std::size_t least) {
    while (hull.size() > least &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point p : points) extend(p, 1);
  const std::size_t lower = hull.size();
  std::reverse(points.begin(), points.end());
  for (const Point p : points) extend(p, lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

std::vector<Shape> shapes_in_view(const Map& map, const View& view) {
  const InnerRings inner = inner_rings(map);
  std::vector<Shape> shapes;
  for (const auto& obstacle : map.obstacles) {
    if (!is_drawable(obstacle) || !meets(extent(obstacle), view.window)) continue;
    shapes.push_back(make_shape(obstacle, inner, view));
  }
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const Shape& p, const Shape& q) { return p.kind < q.kind; });
  return shapes;
}

}  // namespace mapwright::converter
