#include "converter/pipeline/plain_obstacles.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace mapwright::converter {

PlainObstacles::PlainObstacles(double resolution_m)
    : resolution_m_(resolution_m), resolution_(resolution_m) {}

void PlainObstacles::set_points(PlainObstacle& obstacle, std::span<const Point> points) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  static_assert(sizeof(GridPoint) == 2 * sizeof(std::int32_t));
  obstacle.count = static_cast<std::uint32_t>(points.size());
  obstacle.grid_points = room_for(points.size());
  obstacle.on_grid =
      resolution_.units_of({&points.data()->x, 2 * points.size()}, &obstacle.grid_points->x);
  if (obstacle.on_grid) return;
  give_back(points.size());
  obstacle.points = points_.take(points.size());
  std::copy(points.begin(), points.end(), obstacle.points);
}

std::span<const Point> PlainObstacles::chain(const PlainObstacle& obstacle,
                                             std::vector<Point>& room) const {
  if (!obstacle.on_grid) return {obstacle.points, obstacle.count};
  room.clear();
  for (const auto [x, y] : grid_chain(obstacle)) {
    room.push_back({resolution_.of_units(x), resolution_.of_units(y)});
  }
  return room;
}

std::span<const GridPoint> PlainObstacles::grid_chain(const PlainObstacle& obstacle) {
  if (!obstacle.on_grid) return {};
  return {obstacle.grid_points, obstacle.count};
}

void PlainObstacles::reverse(PlainObstacle& obstacle) {
  const auto turn = [&](auto* points) {
    std::reverse(points + (obstacle.joined ? 1 : 0), points + obstacle.count);
  };
  obstacle.on_grid ? turn(obstacle.grid_points) : turn(obstacle.points);
}

std::uint32_t PlainObstacles::style_of(InOut in_out, std::string_view semantic) {
  const auto fits = [&](const Style& style) {
    return style.in_out == in_out && style.semantic.view() == semantic;
  };
  if (!all_.empty() && fits(styles_[all_.back().style])) return all_.back().style;
  std::string key(1, in_out == InOut::kIndoor ? '0' : '1');
  key += semantic;
  const auto [known, is_new] =
      known_styles_.emplace(std::move(key), static_cast<std::uint32_t>(styles_.size()));
  if (is_new) styles_.push_back({in_out, Semantic(semantic)});
  return known->second;
}

// Neighbours often have the same.
void PlainObstacles::set_semantic(PlainObstacle& obstacle, std::string_view semantic) {
  obstacle.semantic_size = static_cast<std::uint32_t>(semantic.size());
  if (!all_.empty() && all_.back().semantic_view() == semantic) {
    obstacle.semantic = all_.back().semantic;
    return;
  }
  char* const text = texts_.take(semantic.size());
  std::memcpy(text, semantic.data(), semantic.size());
  obstacle.semantic = text;
}

void PlainObstacles::add(PlainObstacle obstacle, FeatureKind kind, std::size_t source,
                         std::string_view semantic, InOut in_out,
                         std::string_view segment_semantic) {
  obstacle.style = style_of(in_out, segment_semantic);
  set_semantic(obstacle, semantic);
  append(obstacle, kind, source);
}

void PlainObstacles::append(const PlainObstacle& obstacle, FeatureKind kind, std::size_t source) {
  if (runs_.empty() || runs_.back().kind != kind || runs_.back().source != source) {
    runs_.push_back({kind, source, all_.size(), all_.size()});
  }
  all_.push_back(obstacle);
  ++runs_.back().end;
  segments_ += obstacle.segment_count();
  extend(obstacle);
}

void PlainObstacles::extend(const PlainObstacle& obstacle) {
  if (!obstacle.on_grid) {
    for (std::size_t i = 0; i < obstacle.count; ++i) extent_.add(obstacle.points[i]);
    return;
  }
  auto& box = grid_extent_;
  for (const auto [x, y] : grid_chain(obstacle)) {
    box.min_x = std::min(box.min_x, x);
    box.min_y = std::min(box.min_y, y);
    box.max_x = std::max(box.max_x, x);
    box.max_y = std::max(box.max_y, y);
  }
}

Box PlainObstacles::extent() const {
  Box box = extent_;
  if (grid_extent_.min_x > grid_extent_.max_x) return box;
  const auto& format = resolution_;
  box.add({format.of_units(grid_extent_.min_x), format.of_units(grid_extent_.min_y)});
  box.add({format.of_units(grid_extent_.max_x), format.of_units(grid_extent_.max_y)});
  return box;
}

void PlainObstacles::remove_gone() {
  const LongList<PlainObstacle> before = std::exchange(all_, {});
  const auto runs = std::exchange(runs_, {});
  segments_ = 0;
  grid_extent_ = {};
  extent_ = kEmptyBox;
  for (const auto& run : runs) {
    for (std::size_t i = run.first; i < run.end; ++i) {
      if (!before[i].is_gone) append(before[i], run.kind, run.source);
    }
  }
}

Obstacle as_obstacle(const PlainObstacle& plain, std::span<const Point> chain,
                     const PlainObstacles::Style& style, const Semantic& semantic) {
  Obstacle obstacle{plain.id, plain.shape_type, semantic, {}};
  obstacle.segments.reserve(plain.segment_count());
  for (std::size_t i = 0; i < plain.segment_count(); ++i) {
    const Point b = chain[i + 1 == chain.size() ? 0 : i + 1];
    obstacle.segments.push_back({chain[i], b, plain.height_m, style.in_out, style.semantic});
  }
  return obstacle;
}

}  // namespace mapwright::converter
