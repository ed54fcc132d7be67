#include "mapcore/geometry/orientation.hpp"
#include "tests/validators/mutation_places.hpp"

namespace mapwright::test {
namespace {

bool is_solid(const Obstacle& o) {
  return is_polygon(o) && !o.semantic.has_label("room") &&
         !o.semantic.value(semantic_key::kInnerOf);
}

Point outward(const Segment& s) {
  const Point along = s.b - s.a;
  return (1.0 / length(along)) * Point{along.y, -along.x};
}

Point middle(const Segment& s) {
  return 0.5 * s.a + 0.5 * s.b;
}

// A wall towards the middle of an edge stops a few millimetres before it.
Answer near_miss(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_solid).value();
  const Segment edge = map.obstacles[i].segments[any_segment(map.obstacles[i], random)];
  if (distance(edge.a, edge.b) < 0.1) return std::nullopt;
  const Point end = middle(edge) + random.uniform(0.004, 0.008) * outward(edge);
  const Point start = end + 0.5 * outward(edge);
  const bool ends_there = random.below(2) == 0;
  auto expected = ends_there ? add_obstacle(map, ShapeType::kOpenPolygon, {start, end}, 2.0)
                             : add_obstacle(map, ShapeType::kOpenPolygon, {end, start}, 2.0);
  expected.segments = {1};
  return expected;
}

// A hair grows out of the middle of an edge.
Answer spike(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_solid).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = any_segment(o, random);
  const Segment edge = o.segments[k];
  const double length_m = distance(edge.a, edge.b);
  if (length_m < 0.1) return std::nullopt;
  const Point foot = middle(edge), back = foot + (0.006 / length_m) * (edge.b - edge.a);
  const Point tip = foot + random.uniform(0.5, 2.0) * outward(edge);
  std::vector<Segment> hair(4, edge);
  hair[0].b = hair[1].a = foot;
  hair[1].b = hair[2].a = tip;
  hair[2].b = hair[3].a = back;
  const auto at = o.segments.erase(o.segments.begin() + static_cast<std::ptrdiff_t>(k));
  o.segments.insert(at, hair.begin(), hair.end());
  return Expected{i, {k + 3}};
}

Answer sliver(Map& map, Random& random) {
  const Point p{random.uniform(1.0, 90.0), random.uniform(1.0, 90.0)};
  const Point q = p + Point{random.uniform(0.5, 5.0), random.uniform(0.003, 0.008)};
  return add_obstacle(map, ShapeType::kClosedPolygon, {p, {q.x, p.y}, q, {p.x, q.y}, p}, 2.0);
}

// One more segment from a vertex that the chain has left.
Answer branching_chain(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, [](const Obstacle& o) {
    return (is_polygon(o) || is_wall(o)) && o.segments.size() >= 2;
  });
  Obstacle& o = map.obstacles[*i];
  Segment branch = o.segments[1 + random.below(o.segments.size() - 1)];
  branch.b = branch.a + Point{random.uniform(0.01, 0.4), random.uniform(-0.3, -0.01)};
  o.segments.push_back(branch);
  return Expected{i, {o.segments.size()}};
}

Answer obstacle_inside_obstacle(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, [](const Obstacle& o) {
    return is_rectangle(o) && (o.semantic.has_label("bench") || o.semantic.has_label("table") ||
                               o.semantic.has_label("fountain"));
  });
  if (!i) return std::nullopt;
  const Box box = extent(map.obstacles[*i]);
  const Point c{0.5 * (box.min_x + box.max_x), 0.5 * (box.min_y + box.max_y)};
  const double half_m = random.uniform(0.05, 0.15);
  const Point low = c - Point{half_m, half_m}, high = c + Point{half_m, half_m};
  return add_obstacle(map, ShapeType::kClosedPolygon,
                      {low, {high.x, low.y}, high, {low.x, high.y}, low}, 2.0);
}

Answer border_too_loose(Map& map, Random& random) {
  const double by_m = random.uniform(200.0, 5000.0);
  switch (random.below(4)) {
    case 0:
      map.border.left -= by_m;
      break;
    case 1:
      map.border.top += by_m;
      break;
    case 2:
      map.border.right += by_m;
      break;
    default:
      map.border.bottom -= by_m;
  }
  return Expected{};
}

Answer border_too_tight(Map& map, Random&) {
  Box solids = kEmptyBox;
  for (const auto& o : map.obstacles) {
    if (!is_ring(o) || signed_area_m2(chain_points(o)) < 0.0) continue;
    for (const Point p : chain_points(o)) solids.add(p);
  }
  map.border = {solids.min_x, solids.max_y, solids.max_x, solids.min_y};
  return Expected{};
}

}  // namespace

const std::vector<Mutator>& shape_mutators() {
  static const std::vector<Mutator> all{{FindingCode::G120, near_miss},
                                        {FindingCode::G121, spike},
                                        {FindingCode::G122, sliver},
                                        {FindingCode::G123, branching_chain},
                                        {FindingCode::G124, obstacle_inside_obstacle},
                                        {FindingCode::G125, border_too_loose},
                                        {FindingCode::G126, border_too_tight}};
  return all;
}

}  // namespace mapwright::test
