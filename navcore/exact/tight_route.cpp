#include "navcore/exact/tight_route.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::navcore::exact {
namespace {

std::vector<Point> with_points_between(const std::vector<Point>& route, double step) {
  std::vector<Point> places{route.front()};
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Point from = route[i - 1], to = route[i];
    const double count = std::ceil(distance(from, to) / step);
    for (double k = 1.0; k < count; ++k) places.push_back(from + (k / count) * (to - from));
    if (to != from) places.push_back(to);
  }
  return places;
}

}  // namespace

std::optional<std::vector<Stretch>> cut_route(const std::vector<Point>& route, double step,
                                              const PartAt& part_at) {
  const std::vector<Point> places = with_points_between(route, step);
  std::vector<std::optional<std::uint32_t>> parts;
  for (const Point p : places) parts.push_back(part_at(p));
  if (!parts.front() || !parts.back()) return std::nullopt;
  std::vector<Stretch> stretches;
  const auto cut = [&](std::size_t from, std::size_t to, bool is_within_part) {
    if (from == to) return;
    const auto first = places.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = places.begin() + static_cast<std::ptrdiff_t>(to) + 1;
    stretches.push_back({{first, last}, is_within_part});
  };
  for (std::size_t i = 0; i + 1 < places.size();) {
    const auto last_in_part = std::find(parts.rbegin(), parts.rend(), parts[i]).base() - 1;
    const auto leaving = static_cast<std::size_t>(last_in_part - parts.begin());
    cut(i, leaving, true);
    std::size_t next = leaving + 1;
    while (next < places.size() && !parts[next]) ++next;
    if (next < places.size()) cut(leaving, next, false);
    i = next;
  }
  return stretches;
}

std::optional<std::vector<Point>> pull_taut(const std::vector<Point>& points,
                                            const std::function<bool(Point, Point)>& is_clear) {
  constexpr std::size_t kFarthest = 64;  // points left out at once
  std::vector<Point> taut{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    std::size_t next = std::min(points.size() - 1, i + kFarthest);
    while (next > i + 1 && !is_clear(points[i], points[next])) --next;
    if (next == i + 1 && !is_clear(points[i], points[next])) return std::nullopt;
    taut.push_back(points[next]);
    i = next;
  }
  return taut;
}

}  // namespace mapwright::navcore::exact
