#include "cli/info/map_summary.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>

namespace mapwright::cli {
namespace {

// Smallest value that at least this share of all values does not exceed; `sorted` is not empty.
double nearest_rank(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

void count_segment(const Segment& segment, MapSummary& summary) {
  ++(segment.in_out == InOut::kIndoor ? summary.indoor : summary.outdoor);
  summary.zero_heights += segment.height_m == 0.0 ? 1U : 0U;
  summary.length_m += distance(segment.a, segment.b);
}

void count_obstacle(const Obstacle& obstacle, MapSummary& summary) {
  auto& count = summary.by_shape_type[static_cast<std::size_t>(obstacle.shape_type) - 1];
  ++count.obstacles;
  count.segments += obstacle.segments.size();
  for (const auto& segment : obstacle.segments) count_segment(segment, summary);
}

void measure_circles(const Map& map, MapSummary& summary) {
  std::vector<double> radii_m;
  for (const auto& obstacle : map.obstacles) {
    const Circle circle = min_bounding_circle(obstacle);
    if (circle.radius_m < 0.0) continue;
    radii_m.push_back(circle.radius_m);
    auto& largest = summary.largest_circle;
    if (!largest || circle.radius_m > largest->circle.radius_m) largest = {obstacle.id, circle};
  }
  summary.circle_radii_m = spread_of(std::move(radii_m));
}

std::size_t count_distinct_semantics(const Map& map) {
  std::unordered_set<std::string_view> distinct;
  for (const auto& obstacle : map.obstacles) {
    distinct.insert(obstacle.semantic.view());
    for (const auto& segment : obstacle.segments) distinct.insert(segment.semantic.view());
  }
  distinct.erase(std::string_view());
  return distinct.size();
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  return {values.front(), nearest_rank(values, 0.5), sum / static_cast<double>(values.size()),
          nearest_rank(values, 0.95), values.back()};
}

std::optional<double> MapSummary::bytes_per_m2() const {
  const double area_m2 = border.area_m2();
  if (!(area_m2 > 0.0) || !(border.right > border.left)) return std::nullopt;
  return static_cast<double>(bytes) / area_m2;
}

MapSummary summarize(const MapDocument& document) {
  const Map& map = document.map;
  MapSummary summary;
  summary.bytes = document.text.size();
  summary.obstacles = map.obstacles.size();
  summary.segments = segment_count(map);
  summary.border = map.border;
  summary.extent = extent(map);
  std::vector<double> heights_m;
  std::vector<double> segments;
  for (const auto& obstacle : map.obstacles) {
    count_obstacle(obstacle, summary);
    segments.push_back(static_cast<double>(obstacle.segments.size()));
    for (const auto& segment : obstacle.segments) heights_m.push_back(segment.height_m);
  }
  summary.heights_m = spread_of(std::move(heights_m));
  summary.segments_per_obstacle = spread_of(std::move(segments));
  measure_circles(map, summary);
  summary.distinct_semantics = count_distinct_semantics(map);
  for (const auto& finding : document.findings) {
    ++summary.findings[static_cast<std::size_t>(finding.severity)];
  }
  return summary;
}

}  // namespace mapwright::cli
