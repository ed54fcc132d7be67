#include "converter/pipeline/laid_steps.hpp"

#include <algorithm>
#include <limits>

namespace mapwright::converter {
namespace {

struct Span {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();
  void add(double value) {
    from = std::min(from, value);
    to = std::max(to, value);
  }
};

// Extent along `right` of the outline's cut at `level` along `up`.
Span cut(const std::vector<Point>& outline, Point up, Point right, double level) {
  Span span;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i];
    const Point b = outline[i + 1 == outline.size() ? 0 : i + 1];
    const double at_a = dot(a, up) - level;
    const double at_b = dot(b, up) - level;
    if (at_a * at_b > 0.0 || at_a == at_b) continue;
    const Point p = a + (at_a / (at_a - at_b)) * (b - a);
    span.add(dot(p, right));
  }
  return span;
}

}  // namespace

std::vector<std::vector<Point>> risers_in_outline(const std::vector<Point>& outline, Point up,
                                                  int count) {
  const Point right{up.y, -up.x};
  Span depth;
  for (const Point p : outline) depth.add(dot(p, up));
  const double tread = (depth.to - depth.from) / count;
  std::vector<std::vector<Point>> risers;
  for (int i = 0; i < count; ++i) {
    const double level = depth.from + i * tread;
    // A corner may be all there is at the very foot: the width is taken a little further up.
    const Span width = cut(outline, up, right, level + 0.05 * tread);
    if (!(width.from < width.to)) continue;
    risers.push_back({width.from * right + level * up, width.to * right + level * up});
  }
  return risers;
}

std::vector<std::vector<Point>> risers_across_line(const std::vector<Point>& line, double width_m,
                                                   int count) {
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) total += distance(line[i], line[i + 1]);
  std::vector<std::vector<Point>> risers;
  std::size_t piece = 0;
  double before = 0.0;  // length of the pieces passed
  for (int i = 0; i < count; ++i) {
    const double at = total * i / count;
    while (piece + 2 < line.size() && before + distance(line[piece], line[piece + 1]) <= at) {
      before += distance(line[piece], line[piece + 1]);
      ++piece;
    }
    const double piece_length = distance(line[piece], line[piece + 1]);
    const Point up = (1.0 / piece_length) * (line[piece + 1] - line[piece]);
    const Point center = line[piece] + (at - before) * up;
    const Point half = (0.5 * width_m) * Point{up.y, -up.x};
    risers.push_back({center - half, center + half});
  }
  return risers;
}

}  // namespace mapwright::converter
