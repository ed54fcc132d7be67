#include "converter/pipeline/clean_path.hpp"

namespace mapwright::converter {

CleanPath clean_path(const SourceGeometry& geometry, const SourcePath& path,
                     const text::DecimalFormat& resolution) {
  CleanPath clean;
  clean.curved = path.curved;
  clean.points.reserve(path.count);
  const std::size_t end = path.first + path.count;
  for (std::size_t i = path.first; i < end; ++i) {
    const Point p{geometry.xs[i], geometry.ys[i]};
    if (i > path.first && p == Point{geometry.xs[i - 1], geometry.ys[i - 1]})
      clean.had_repeats = true;
    const Point snapped{resolution.rounded(p.x), resolution.rounded(p.y)};
    if (clean.points.empty() || clean.points.back() != snapped) clean.points.push_back(snapped);
  }
  while (clean.points.size() > 1 && clean.points.front() == clean.points.back()) {
    clean.points.pop_back();
    clean.closed = true;
  }
  return clean;
}

}  // namespace mapwright::converter
