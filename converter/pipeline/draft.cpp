#include "converter/pipeline/draft.hpp"

namespace mapwright::converter {

std::vector<Segment> chain_of(const std::vector<Point>& points, bool closed,
                              const SegmentStyle& style) {
  std::vector<Segment> segments;
  const std::size_t count = points.empty() ? 0 : points.size() - (closed ? 0 : 1);
  segments.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point b = points[i + 1 == points.size() ? 0 : i + 1];
    segments.push_back({points[i], b, style.height_m, style.in_out, style.semantic});
  }
  return segments;
}

}  // namespace mapwright::converter
