#include "mapcore/map.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace mapwright {
namespace {

std::optional<double> finite_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

void append_rounded(std::string& text, double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  char buffer[32];
  const auto result =
      std::to_chars(std::begin(buffer), std::end(buffer), rounded == 0.0 ? 0.0 : rounded,
                    std::chars_format::fixed);
  text.append(std::begin(buffer), result.ptr);
}

}  // namespace

std::size_t segment_count(const Map& map) {
  std::size_t count = 0;
  for (const auto& obstacle : map.obstacles) count += obstacle.segments.size();
  return count;
}

std::vector<Point> chain_points(const Obstacle& obstacle) {
  std::vector<Point> points;
  if (obstacle.segments.empty()) return points;
  points.reserve(obstacle.segments.size() + 1);
  for (const auto& segment : obstacle.segments) points.push_back(segment.a);
  if (obstacle.segments.back().b != points.front()) points.push_back(obstacle.segments.back().b);
  return points;
}

Box extent(const Obstacle& obstacle) {
  Box box = kEmptyBox;
  for (const auto& segment : obstacle.segments) {
    box.add(segment.a);
    box.add(segment.b);
  }
  return box;
}

Box extent(const Map& map) {
  Box box = kEmptyBox;
  for (const auto& obstacle : map.obstacles) {
    const Box part = extent(obstacle);
    if (part.is_empty()) continue;
    box.add({part.min_x, part.min_y});
    box.add({part.max_x, part.max_y});
  }
  return box;
}

double max_height_m(const Obstacle& obstacle) {
  double height = 0.0;
  for (const auto& segment : obstacle.segments) height = std::max(height, segment.height_m);
  return height;
}

std::optional<Normal> ramp_normal(const Obstacle& ramp) {
  const auto text = ramp.semantic.value(semantic_key::kNormal);
  if (!text) return std::nullopt;
  const auto first = text->find(':');
  if (first == text->npos) return std::nullopt;
  const auto second = text->find(':', first + 1);
  if (second == text->npos) return std::nullopt;
  const auto x = finite_number(text->substr(0, first));
  const auto y = finite_number(text->substr(first + 1, second - first - 1));
  const auto z = finite_number(text->substr(second + 1));
  if (!x || !y || !z) return std::nullopt;
  return Normal{*x, *y, *z};
}

std::string format_normal(const Normal& normal) {
  std::string text;
  append_rounded(text, normal.x);
  text += ':';
  append_rounded(text, normal.y);
  text += ':';
  append_rounded(text, normal.z);
  return text;
}

RampPlane::RampPlane(const Normal& normal, const std::vector<Point>& footprint)
    : gradient_{-normal.x / normal.z, -normal.y / normal.z} {
  assert(normal.z > 0.0 && !footprint.empty());
  double lowest = HUGE_VAL;
  for (const Point p : footprint) lowest = std::min(lowest, dot(gradient_, p));
  offset_ = -lowest;
}

}  // namespace mapwright
