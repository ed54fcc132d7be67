#include "tests/validators/mutators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/validators/mutation_places.hpp"

namespace mapwright::test {
namespace {

Answer invalid_border(Map& map, Random& random) {
  if (random.below(2) == 0) {
    std::swap(map.border.left, map.border.right);
  } else {
    std::swap(map.border.top, map.border.bottom);
  }
  return Expected{};
}

Answer absurd_coordinate(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ring).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = any_segment(o, random);
  const Point p = o.segments[k].a;
  set_vertex(o, k, random.below(2) == 0 ? Point{p.x + 4.0e6, p.y} : Point{p.x, p.y - 4.0e6});
  return Expected{i, {first_at_vertex(o, k)}};
}

Answer zero_length_segment(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ring).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = any_segment(o, random);
  Segment extra = o.segments[k];
  extra.b = extra.a;
  o.segments.insert(o.segments.begin() + static_cast<std::ptrdiff_t>(k), extra);
  return Expected{i, {k + 1}};
}

// Two neighbouring corners of a rectangle change places: a bow tie. Its diagonals, two and four
// segments on, cross.
Answer self_intersection(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_rectangle).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = any_segment(o, random);
  const std::size_t next = (k + 1) % 4;
  const Point p = o.segments[k].a, q = o.segments[next].a;
  set_vertex(o, k, q);
  set_vertex(o, next, p);
  return Expected{i, {std::max((k + 3) % 4, next) + 1}};
}

Answer unclosed_shape(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ring).value();
  Obstacle& o = map.obstacles[i];
  o.segments.back().b = o.segments.back().b + Point{random.uniform(0.002, 0.5), 0.0};
  return Expected{i, {o.segments.size()}};
}

Answer broken_chain(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ring).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = 1 + random.below(o.segments.size() - 1);
  o.segments[k].a = o.segments[k].a + Point{0.0, random.uniform(0.002, 0.5)};
  return Expected{i, {k + 1}};
}

// Rings that are solid or a courtyard, and the wall that leans on one. What holds something may run
// either way.
Answer wrong_orientation(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, [](const Obstacle& o) {
    return (is_ring(o) && !o.semantic.has_label("room")) || o.semantic.has_label("railing") ||
           o.semantic.view() == "fence";
  });
  Obstacle& o = map.obstacles[*i];
  if (is_wall(o) && !o.semantic.has_label("railing") && o.segments.size() > 1) return std::nullopt;
  reverse(o);
  return is_wall(o) ? Expected{i, {1}} : Expected{i, {}};
}

Answer overlap(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, [](const Obstacle& o) {
    return is_polygon(o) && !o.semantic.has_label("room") &&
           !o.semantic.value(semantic_key::kInnerOf);
  });
  Obstacle copy = map.obstacles[*i];
  copy.id = map.obstacles.back().id + 1;
  const Point by{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
  for (auto& s : copy.segments) {
    s.a = s.a + by;
    s.b = s.b + by;
  }
  map.obstacles.push_back(copy);
  Expected expected{map.obstacles.size() - 1, {}};
  for (std::size_t k = 1; k <= copy.segments.size(); ++k) expected.segments.push_back(k);
  return expected;
}

Answer outside_border(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ring).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = any_segment(o, random);
  set_vertex(o, k, {map.border.right + random.uniform(0.01, 5.0), o.segments[k].a.y});
  return Expected{i, {first_at_vertex(o, k)}};
}

Answer degenerate_outline(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_polygon).value();
  Obstacle& o = map.obstacles[i];
  const Point start = o.segments.front().a;
  for (std::size_t k = 0; k < o.segments.size(); ++k) {
    set_vertex(o, k, start + Point{0.25 * static_cast<double>(k), 0.0});
  }
  return Expected{i, {}};
}

Answer duplicate_segment(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, [](const Obstacle& o) { return !is_ramp(o); }).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t k = any_segment(o, random);
  o.segments.insert(o.segments.begin() + static_cast<std::ptrdiff_t>(k), o.segments[k]);
  return Expected{i, {k + 2}};
}

Answer no_segments(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_any).value();
  map.obstacles[i].segments.clear();
  return Expected{i, {}};
}

Answer duplicate_id(Map& map, Random& random) {
  const std::size_t later = 1 + random.below(map.obstacles.size() - 1);
  map.obstacles[later].id = map.obstacles[random.below(later)].id;
  return Expected{later, {}};
}

Answer negative_id(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_any).value();
  map.obstacles[i].id = -1 - static_cast<std::int64_t>(random.below(1000));
  return Expected{i, {}};
}

Answer empty_semantic(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_any).value();
  map.obstacles[i].semantic = random.below(2) == 0 ? "" : ", ,";
  return Expected{i, {}};
}

Answer unreadable_semantic(Map& map, Random& random) {
  static constexpr const char* kUnreadable[] = {"pla\u00c3\u00a7a", "pla\ufffda", "pla\u200ba",
                                                "pla\x07"};
  const auto i = any_obstacle(map, random, is_any).value();
  Obstacle& o = map.obstacles[i];
  const Semantic text(kUnreadable[random.below(4)]);
  if (random.below(2) == 0) {
    o.semantic = text;
    return Expected{i, {}};
  }
  const std::size_t k = any_segment(o, random);
  o.segments[k].semantic = text;
  return Expected{i, {k + 1}};
}

Answer orphan_inner_ring(Map& map, Random& random) {
  static constexpr const char* kOuters[] = {"999999", "none", "-3", ""};
  const auto i = any_obstacle(map, random, is_polygon).value();
  Obstacle& o = map.obstacles[i];
  // Its own id, an id that nobody has, no id at all.
  const auto choice = random.below(5);
  o.semantic = o.semantic.with_value(semantic_key::kInnerOf,
                                     choice == 4 ? std::to_string(o.id) : kOuters[choice]);
  return Expected{i, {}};
}

Answer negative_height(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_any).value();
  const std::size_t k = any_segment(map.obstacles[i], random);
  map.obstacles[i].segments[k].height_m = -random.uniform(0.01, 10.0);
  return Expected{i, {k + 1}};
}

Answer absurd_height(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_any).value();
  const std::size_t k = any_segment(map.obstacles[i], random);
  map.obstacles[i].segments[k].height_m = random.uniform(1001.0, 1.0e5);
  return Expected{i, {k + 1}};
}

// Two neighbouring steps exchange their heights.
Answer step_order(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const auto steps = steps_of(o);
  const std::size_t n = random.below(steps.size() - 1);
  std::swap(o.segments[steps[n]].height_m, o.segments[steps[n + 1]].height_m);
  return Expected{i, {steps[n + 1] + 1}};
}

Answer missing_top(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t top = top_of(o);
  if (random.below(2) == 0) {
    o.segments.erase(o.segments.begin() + static_cast<std::ptrdiff_t>(top));
  } else if (top == 0) {
    std::rotate(o.segments.begin(), o.segments.begin() + 1, o.segments.end());
  } else {
    std::rotate(o.segments.begin(), o.segments.end() - 1, o.segments.end());
  }
  return Expected{i, {}};
}

Answer top_not_reversed(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  std::swap(o.segments[top_of(o)].a, o.segments[top_of(o)].b);
  return Expected{i, {top_of(o) + 1}};
}

// The highest step is a decimal point too high, or hardly higher than the one below.
Answer implausible_rise(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const auto steps = steps_of(o);
  const bool rises = top_of(o) != 0;
  const std::size_t highest = rises ? steps.back() : steps.front();
  const std::size_t below = rises ? highest - 1 : highest + 1;
  o.segments[highest].height_m = random.below(2) == 0
                                     ? 10.0 * o.segments[highest].height_m
                                     : o.segments[below].height_m + random.uniform(0.002, 0.015);
  return Expected{i, {highest + 1}};
}

Answer steps_not_parallel(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const auto steps = steps_of(o);
  const std::size_t n = 1 + random.below(steps.size() - 1);
  Segment& s = o.segments[steps[n]];
  const double angle = random.uniform(15.0, 80.0) * std::numbers::pi / 180.0;
  const Point half = 0.5 * (s.b - s.a), middle = s.a + half;
  const Point turned{std::cos(angle) * half.x - std::sin(angle) * half.y,
                     std::sin(angle) * half.x + std::cos(angle) * half.y};
  s.a = middle - turned;
  s.b = middle + turned;
  return Expected{i, {steps[n] + 1}};
}

Answer steps_oppose(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const auto steps = steps_of(o);
  Segment& s = o.segments[steps[random.below(steps.size())]];
  std::swap(s.a, s.b);
  return Expected{i, {static_cast<std::size_t>(&s - o.segments.data()) + 1}};
}

Answer missing_normal(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ramp).value();
  map.obstacles[i].semantic = "ramp";
  return Expected{i, {}};
}

Answer invalid_normal(Map& map, Random& random) {
  static constexpr const char* kInvalid[] = {"0:0:-1", "0:0:1.1", "0:1", "up", "0:0:0", "0:0:0.99"};
  const auto i = any_obstacle(map, random, is_ramp).value();
  map.obstacles[i].semantic =
      map.obstacles[i].semantic.with_value(semantic_key::kNormal, kInvalid[random.below(6)]);
  return Expected{i, {}};
}

Answer ramp_height(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ramp).value();
  const std::size_t k = any_segment(map.obstacles[i], random);
  map.obstacles[i].segments[k].height_m = random.uniform(0.01, 3.0);
  return Expected{i, {k + 1}};
}

Answer steep_ramp(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ramp).value();
  const double slope = random.uniform(21.0, 80.0) * std::numbers::pi / 180.0;
  const Normal normal{std::sin(slope), 0.0, std::cos(slope)};
  map.obstacles[i].semantic =
      map.obstacles[i].semantic.with_value(semantic_key::kNormal, format_normal(normal));
  return Expected{i, {}};
}

}  // namespace

const std::vector<Mutator>& coarse_mutators() {
  static const std::vector<Mutator> all{
      {FindingCode::G101, invalid_border},      {FindingCode::G102, absurd_coordinate},
      {FindingCode::G103, zero_length_segment}, {FindingCode::G104, self_intersection},
      {FindingCode::G105, unclosed_shape},      {FindingCode::G106, broken_chain},
      {FindingCode::G107, wrong_orientation},   {FindingCode::G108, overlap},
      {FindingCode::G109, outside_border},      {FindingCode::G110, degenerate_outline},
      {FindingCode::G111, duplicate_segment},   {FindingCode::G112, no_segments},
      {FindingCode::S101, duplicate_id},        {FindingCode::S102, negative_id},
      {FindingCode::S103, empty_semantic},      {FindingCode::S104, unreadable_semantic},
      {FindingCode::S105, orphan_inner_ring},   {FindingCode::S106, negative_height},
      {FindingCode::S107, absurd_height},       {FindingCode::T101, step_order},
      {FindingCode::T102, missing_top},         {FindingCode::T103, top_not_reversed},
      {FindingCode::T104, implausible_rise},    {FindingCode::T105, steps_not_parallel},
      {FindingCode::T106, steps_oppose},        {FindingCode::T201, missing_normal},
      {FindingCode::T202, invalid_normal},      {FindingCode::T203, ramp_height},
      {FindingCode::T204, steep_ramp}};
  return all;
}

const std::vector<Mutator>& mutators() {
  static const std::vector<Mutator> all = [] {
    std::vector<Mutator> joined = coarse_mutators();
    for (const auto* more : {&shape_mutators(), &attribute_mutators(), &stairs_mutators()}) {
      joined.insert(joined.end(), more->begin(), more->end());
    }
    return joined;
  }();
  return all;
}

}  // namespace mapwright::test
