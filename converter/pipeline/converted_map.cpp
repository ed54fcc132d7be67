#include "converter/pipeline/converted_map.hpp"

namespace mapwright::converter {

Semantic tied_to(std::int64_t outer, const Semantic& semantic) {
  const std::string id = std::to_string(outer);
  const bool is_tied = semantic.value(semantic_key::kInnerOf) == id;
  return is_tied ? semantic : semantic.with_value(semantic_key::kInnerOf, id);
}

std::size_t ConvertedMap::segment_count() const {
  std::size_t count = plain_.segment_count();
  for (const auto& obstacle : others_) count += obstacle.segments.size();
  return count;
}

Box ConvertedMap::extent() const {
  Box box = plain_.extent();
  for (const auto& obstacle : others_) {
    for (const auto& segment : obstacle.segments) {
      box.add(segment.a);
      box.add(segment.b);
    }
  }
  return box;
}

// Holes name the outline they lie in, whose id is known only now.
void ConvertedMap::visit_plain(const Run& run, const PlainVisitor& visit) const {
  std::int64_t outer = 0;
  for (std::size_t i = run.first; i < run.end; ++i) {
    const auto& plain = plain_.all()[i];
    if (!plain.is_inner) {
      outer = plain.id;
      visit(plain, plain.semantic_view());
      continue;
    }
    visit(plain, tied_to(outer, Semantic(plain.semantic_view())).view());
  }
}

void ConvertedMap::write(std::ostream& out, WriteOptions options, const Progress& progress) const {
  MapWriter writer(out, options);
  const bool keeps_grid = options.resolution_m == plain_.resolution_m();
  std::vector<Point> room;
  std::size_t done = 0;
  const auto tell = [&] {
    if (progress && ++done % 1024 == 0) progress(done, obstacle_count());
  };
  writer.border(border);
  for (const auto& run : runs_) {
    for (std::size_t i = run.first; !run.plain && i < run.end; ++i) {
      writer.obstacle(others_[i]);
      tell();
    }
    if (!run.plain) continue;
    visit_plain(run, [&](const PlainObstacle& plain, std::string_view semantic) {
      tell();
      const auto& style = plain_.style(plain);
      const bool on_grid = keeps_grid && plain.on_grid;
      writer.obstacle({.id = plain.id,
                       .shape_type = plain.shape_type,
                       .semantic = semantic,
                       .points = on_grid ? std::span<const Point>() : plain_.chain(plain, room),
                       .grid_points = on_grid ? PlainObstacles::grid_chain(plain)
                                              : std::span<const GridPoint>(),
                       .joined = plain.joined,
                       .height_m = plain.height_m,
                       .in_out = style.in_out,
                       .segment_semantic = style.semantic.view()});
    });
  }
  writer.finish();
  if (progress) progress(obstacle_count(), obstacle_count());
}

Map ConvertedMap::whole() const {
  Map map;
  std::vector<Point> room;
  map.border = border;
  map.obstacles.reserve(obstacle_count());
  for (const auto& run : runs_) {
    for (std::size_t i = run.first; !run.plain && i < run.end; ++i) {
      map.obstacles.push_back(others_[i]);
    }
    if (!run.plain) continue;
    visit_plain(run, [&](const PlainObstacle& plain, std::string_view semantic) {
      map.obstacles.push_back(
          as_obstacle(plain, plain_.chain(plain, room), plain_.style(plain), Semantic(semantic)));
    });
  }
  return map;
}

}  // namespace mapwright::converter
