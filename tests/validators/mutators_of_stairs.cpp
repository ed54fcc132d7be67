#include <cmath>
#include <numbers>

#include "tests/validators/mutation_places.hpp"

namespace mapwright::test {
namespace {

std::vector<std::size_t> upward_steps(const Obstacle& stairs) {
  auto steps = steps_of(stairs);
  if (top_of(stairs) == 0) std::reverse(steps.begin(), steps.end());
  return steps;
}

void move(Segment& s, Point by) {
  s.a = s.a + by;
  s.b = s.b + by;
}

Point middle(const Segment& s) {
  return 0.5 * s.a + 0.5 * s.b;
}

// From the step below the highest one to that.
Point upwards(const Obstacle& stairs) {
  const auto steps = upward_steps(stairs);
  return middle(stairs.segments[steps.back()]) - middle(stairs.segments[steps[steps.size() - 2]]);
}

void turn(Segment& s, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const Point half = 0.5 * (s.b - s.a), at = s.a + half;
  const Point turned{std::cos(angle) * half.x - std::sin(angle) * half.y,
                     std::sin(angle) * half.x + std::cos(angle) * half.y};
  s.a = at - turned;
  s.b = at + turned;
}

void set_width(Segment& s, double width_m) {
  const Point half = (0.5 * width_m / distance(s.a, s.b)) * (s.b - s.a), at = middle(s);
  s.a = at - half;
  s.b = at + half;
}

// The highest step moves along the way up, to this tread.
Answer move_highest(Map& map, Random& random, double tread_m) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const Point up = upwards(o);
  const std::size_t highest = upward_steps(o).back();
  move(o.segments[highest], (tread_m / length(up) - 1.0) * up);
  return Expected{i, {highest + 1}};
}

Answer implausible_tread(Map& map, Random& random) {
  const bool short_one = random.below(2) == 0;
  return move_highest(map, random,
                      short_one ? random.uniform(0.01, 0.09) : random.uniform(5.1, 20.0));
}

Answer irregular_tread(Map& map, Random& random) {
  const bool short_one = random.below(2) == 0;
  return move_highest(map, random,
                      short_one ? random.uniform(0.11, 0.16) : random.uniform(0.45, 0.75));
}

Answer irregular_rise(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const std::size_t highest = upward_steps(o).back();
  const double by_m = random.uniform(0.06, 0.12);
  o.segments[highest].height_m += random.below(2) == 0 ? by_m : -by_m;
  return Expected{i, {highest + 1}};
}

Answer too_narrow(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const auto steps = steps_of(o);
  const std::size_t k = steps[random.below(steps.size())];
  set_width(o.segments[k], random.uniform(0.05, 0.39));
  return Expected{i, {k + 1}};
}

Answer uneven_width(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const auto steps = upward_steps(o);
  Segment& s = o.segments[steps[1 + random.below(steps.size() - 1)]];
  const double ratio = random.below(2) == 0 ? random.uniform(0.2, 0.45) : random.uniform(2.1, 5.0);
  set_width(s, ratio * distance(s.a, s.b));
  return Expected{i, {static_cast<std::size_t>(&s - o.segments.data()) + 1}};
}

Answer top_misplaced(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  const Point up = upwards(o);
  const double by_m = random.below(2) == 0 ? -random.uniform(0.4, 3.0) : random.uniform(5.1, 9.0);
  move(o.segments[top_of(o)], (by_m / length(up)) * up);
  return Expected{i, {top_of(o) + 1}};
}

Answer top_not_parallel(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_stairs).value();
  Obstacle& o = map.obstacles[i];
  turn(o.segments[top_of(o)], random.uniform(11.0, 80.0));
  return Expected{i, {top_of(o) + 1}};
}

// Level, or along wrong axes so steep that the ramp ends above the roofs.
Answer ramp_rise(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_ramp).value();
  const double slope =
      (random.below(2) == 0 ? 0.01 : random.uniform(80.0, 85.0)) * std::numbers::pi / 180.0;
  const Normal normal{0.0, std::sin(slope), std::cos(slope)};
  map.obstacles[i].semantic =
      map.obstacles[i].semantic.with_value(semantic_key::kNormal, format_normal(normal));
  return Expected{i, {}};
}

}  // namespace

const std::vector<Mutator>& stairs_mutators() {
  static const std::vector<Mutator> all{
      {FindingCode::T120, implausible_tread}, {FindingCode::T121, irregular_rise},
      {FindingCode::T122, irregular_tread},   {FindingCode::T123, too_narrow},
      {FindingCode::T124, uneven_width},      {FindingCode::T125, top_misplaced},
      {FindingCode::T126, top_not_parallel},  {FindingCode::T130, ramp_rise}};
  return all;
}

}  // namespace mapwright::test
