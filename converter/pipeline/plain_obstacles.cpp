#include "converter/pipeline/plain_obstacles.hpp"

#include <cstring>
#include <utility>

namespace mapwright::converter {

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
  for (const Point p : obstacle.chain()) extent_.add(p);
}

void PlainObstacles::remove_gone() {
  const LongList<PlainObstacle> before = std::exchange(all_, {});
  const auto runs = std::exchange(runs_, {});
  segments_ = 0;
  extent_ = kEmptyBox;
  for (const auto& run : runs) {
    for (std::size_t i = run.first; i < run.end; ++i) {
      if (!before[i].is_gone) append(before[i], run.kind, run.source);
    }
  }
}

Obstacle as_obstacle(const PlainObstacle& plain, const PlainObstacles::Style& style,
                     const Semantic& semantic) {
  const auto chain = plain.chain();
  Obstacle obstacle{plain.id, plain.shape_type, semantic, {}};
  obstacle.segments.reserve(plain.segment_count());
  for (std::size_t i = 0; i < plain.segment_count(); ++i) {
    const Point b = chain[i + 1 == chain.size() ? 0 : i + 1];
    obstacle.segments.push_back({chain[i], b, plain.height_m, style.in_out, style.semantic});
  }
  return obstacle;
}

}  // namespace mapwright::converter
