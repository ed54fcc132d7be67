#include "converter/exporters/picture/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapwright::converter {
namespace {

constexpr double kSize_pt = 6.5;
constexpr double kPadding_pt = 2.0;
constexpr int kLevels = 9;

struct Interval {
  double begin = 0.0, end = 0.0;
  double width() const { return end - begin; }
};

// Where the horizontal line at y runs inside of the rings.
std::vector<Interval> inside_at(const std::vector<std::vector<Point>>& rings, double y) {
  std::vector<double> crossings;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    intervals.push_back({crossings[i], crossings[i + 1]});
  }
  return intervals;
}

std::vector<Interval> intersection(const std::vector<Interval>& p, const std::vector<Interval>& q) {
  std::vector<Interval> both;
  for (const auto& a : p) {
    for (const auto& b : q) {
      const Interval common{std::max(a.begin, b.begin), std::min(a.end, b.end)};
      if (common.width() > 0.0) both.push_back(common);
    }
  }
  return both;
}

std::string label_text(const Shape& shape, PictureLabels labels) {
  const Obstacle& obstacle = *shape.obstacle;
  const bool is_hole = obstacle.semantic.value(semantic_key::kInnerOf).has_value();
  if (is_hole && labels != PictureLabels::kIds) return "";
  if (labels == PictureLabels::kIds) return std::to_string(obstacle.id);
  if (labels == PictureLabels::kNames) {
    return std::string(obstacle.semantic.value(semantic_key::kName).value_or(""));
  }
  if (shape.kind == ObstacleKind::kRamp) return "";
  // As exact as a person cares for: centimetres of a step, decimetres of a house.
  const double height_m = max_height_m(obstacle);
  const double unit_m = height_m < 10.0 ? 0.01 : 0.1;
  return plain_number(std::round(height_m / unit_m) * unit_m);
}

bool overlap(const Box& a, const Box& b) {
  return a.min_x < b.max_x && b.min_x < a.max_x && a.min_y < b.max_y && b.min_y < a.max_y;
}

Box common_part(const Box& a, const Box& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

class Placer {
 public:
  Placer(Canvas& canvas, const View& view, const std::vector<Shape>& shapes, PictureLabels labels)
      : canvas_(canvas), view_(view), labels_(labels) {
    for (const auto& shape : shapes) {
      for (const auto& segment : shape.obstacle->segments) lines_.push_back(page_box(segment));
    }
  }

  void place(const Shape& shape) {
    const std::string text = label_text(shape, labels_);
    if (text.empty()) return;
    const TextSize size = text_size(text, style_);
    if (is_plain_area(shape) && place_within(shape, text, size)) return;
    if (view_.line_scale() < 0.8) return;  // beside their shapes labels would fill a small map
    if (is_area(shape)) {
      place_beside(shape, text, size);
    } else {
      place_along(shape, text, size);
    }
  }

 private:
  static bool is_area(const Shape& shape) {
    return shape.kind != ObstacleKind::kWall && shape.kind != ObstacleKind::kLowWall;
  }

  // Stairs and ramps carry an arrow where the label would stand, and columns are dark.
  static bool is_plain_area(const Shape& shape) {
    return is_area(shape) && shape.kind != ObstacleKind::kStairs &&
           shape.kind != ObstacleKind::kRamp && shape.kind != ObstacleKind::kColumn;
  }

  Box page_box(const Segment& segment) const {
    Box box = kEmptyBox;
    box.add(view_.to_page(segment.a));
    box.add(view_.to_page(segment.b));
    return box;
  }

  static Box box_around(Point middle, TextSize size) {
    return {middle.x - size.width_pt / 2 - kPadding_pt, middle.y - size.height_pt / 2 - kPadding_pt,
            middle.x + size.width_pt / 2 + kPadding_pt,
            middle.y + size.height_pt / 2 + kPadding_pt};
  }

  bool is_open(const Box& box) const {
    return box.min_x >= view_.panel.min_x && box.max_x <= view_.panel.max_x &&
           box.min_y >= view_.panel.min_y && box.max_y <= view_.panel.max_y &&
           std::none_of(taken_.begin(), taken_.end(),
                        [&](const Box& b) { return overlap(b, box); });
  }

  bool hits_a_line(const Box& box) const {
    return std::any_of(lines_.begin(), lines_.end(),
                       [&](const Box& line) { return overlap(line, box); });
  }

  bool write(Point middle, const std::string& text, TextSize size) {
    const Box box = box_around(middle, size);
    if (!is_open(box)) return false;
    taken_.push_back(box);
    canvas_.text(middle, text, style_);
    return true;
  }

  bool place_within(const Shape& shape, const std::string& text, TextSize size) {
    const Room room =
        widest_room(shape.rings, common_part(shape.box, view_.panel), size.height_pt + kPadding_pt);
    if (room.width_pt < size.width_pt + 2.0 * kPadding_pt) return false;
    return write(room.middle, text, size);
  }

  void place_beside(const Shape& shape, const std::string& text, TextSize size) {
    const Box& box = shape.box;
    const Point centre{(box.min_x + box.max_x) / 2, (box.min_y + box.max_y) / 2};
    const double dx = box.width() / 2 + size.width_pt / 2 + 2.0 * kPadding_pt;
    const double dy = box.height() / 2 + size.height_pt / 2 + 2.0 * kPadding_pt;
    const std::array<Point, 4> offsets{{{dx, 0.0}, {0.0, -dy}, {-dx, 0.0}, {0.0, dy}}};
    for (const Point offset : offsets) {
      const Point middle = centre + offset;
      if (!hits_a_line(box_around(middle, size)) && write(middle, text, size)) return;
    }
  }

  // Beside the middle of the longest segment, on the side that is not the ticks'.
  void place_along(const Shape& shape, const std::string& text, TextSize size) {
    const auto& segments = shape.obstacle->segments;
    const auto longest = std::max_element(
        segments.begin(), segments.end(),
        [](const Segment& s, const Segment& t) { return distance(s.a, s.b) < distance(t.a, t.b); });
    const Point a = view_.to_page(longest->a);
    const Point b = view_.to_page(longest->b);
    const double extent = distance(a, b);
    if (extent < 3.0 * size.width_pt) return;
    const Point left = (1.0 / extent) * Point{b.y - a.y, a.x - b.x};
    const double away =
        std::abs(left.x) * size.width_pt / 2 + std::abs(left.y) * size.height_pt / 2;
    write(0.5 * (a + b) + (away + 1.5 * kPadding_pt) * left, text, size);
  }

  Canvas& canvas_;
  const View& view_;
  PictureLabels labels_;
  TextStyle style_{.size_pt = kSize_pt,
                   .colour = Colour::from_hex(0x2B2B2B),
                   .horizontal = Align::kMiddle,
                   .vertical = Align::kMiddle,
                   .halo = Colour::from_hex(0xFFFFFF, 0.75)};
  std::vector<Box> lines_;  // of the segments
  std::vector<Box> taken_;  // of the labels
};

double size_of(const Shape& shape) {
  return shape.box.width() * shape.box.height();
}

}  // namespace

Room widest_room(const std::vector<std::vector<Point>>& rings, const Box& box, double height_pt) {
  Room best;
  double best_score = 0.0;
  for (int level = 1; level < kLevels; ++level) {
    const double y = box.min_y + box.height() * level / kLevels;
    auto intervals = intersection(inside_at(rings, y), {{box.min_x, box.max_x}});
    for (const double edge : {y - height_pt / 2, y + height_pt / 2}) {
      intervals = intersection(intervals, inside_at(rings, edge));
    }
    for (const auto& interval : intervals) {
      // The middle levels win where several are about as wide.
      const double off_centre = std::abs(2.0 * level / kLevels - 1.0);
      const double score = interval.width() * (1.0 - 0.2 * off_centre);
      if (score <= best_score) continue;
      best_score = score;
      best = {{(interval.begin + interval.end) / 2, y}, interval.width()};
    }
  }
  return best;
}

void draw_labels(Canvas& canvas, const View& view, const std::vector<Shape>& shapes,
                 PictureLabels labels) {
  if (labels == PictureLabels::kNone) return;
  std::vector<const Shape*> order;
  order.reserve(shapes.size());
  for (const auto& shape : shapes) order.push_back(&shape);
  std::stable_sort(order.begin(), order.end(),
                   [](const Shape* p, const Shape* q) { return size_of(*p) > size_of(*q); });
  Placer placer(canvas, view, shapes, labels);
  for (const auto* shape : order) {
    if (!shape->box.is_empty()) placer.place(*shape);
  }
}

}  // namespace mapwright::converter
