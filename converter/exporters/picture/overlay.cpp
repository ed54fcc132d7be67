#include "converter/exporters/picture/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mapwright::converter {
namespace {

constexpr Colour kWhite = Colour::from_hex(0xFFFFFF);

void draw_robot(Canvas& canvas, Point centre, Point ahead, double radius_pt, Colour colour) {
  const Point left{ahead.y, -ahead.x};
  const std::vector<Point> nose{centre + 2.2 * radius_pt * ahead,
                                centre + 0.95 * radius_pt * left + 0.3 * radius_pt * ahead,
                                centre - 0.95 * radius_pt * left + 0.3 * radius_pt * ahead};
  canvas.add_path(nose, true);
  canvas.stroke({kWhite, 2.0});
  canvas.add_circle(centre, radius_pt);
  canvas.stroke({kWhite, 2.0});
  canvas.add_path(nose, true);
  canvas.fill(colour);
  canvas.add_circle(centre, radius_pt);
  canvas.fill(colour);
  canvas.add_circle(centre, 0.4 * radius_pt);
  canvas.fill(kWhite);
}

// A drop that stands on its tip, its head above the place.
void draw_pin(Canvas& canvas, Point tip, Colour colour) {
  constexpr double kHead_pt = 3.2;
  constexpr double kHeight_pt = 9.0;
  constexpr int kCorners = 20;
  const Point centre{tip.x, tip.y - kHeight_pt};
  // From one tangent of the tip around the head to the other.
  const double open = std::acos(kHead_pt / kHeight_pt);
  std::vector<Point> drop{tip};
  for (int i = 0; i <= kCorners; ++i) {
    const double angle =
        std::numbers::pi / 2 + open + (2.0 * (std::numbers::pi - open)) * i / kCorners;
    drop.push_back(centre + kHead_pt * Point{std::cos(angle), std::sin(angle)});
  }
  canvas.add_path(drop, true);
  canvas.fill(colour, true);
  canvas.stroke({kWhite, 0.8});
  canvas.add_circle(centre, 1.1);
  canvas.fill(kWhite);
}

class Drawer {
 public:
  Drawer(Canvas& canvas, const View& view) : canvas_(canvas), view_(view) {}

  void operator()(const OverlayPath& path) {
    const auto points = view_.to_page(path.points);
    if (path.fill) {
      canvas_.add_path(points, true);
      canvas_.fill(*path.fill);
    }
    canvas_.add_path(points, path.closed);
    canvas_.stroke(path.stroke);
  }

  void operator()(const OverlaySegments& lines) {
    for (const auto& [a, b] : lines.segments) canvas_.add_line(view_.to_page(a), view_.to_page(b));
    canvas_.stroke(lines.stroke);
  }

  void operator()(const OverlayDots& dots) {
    for (const Point centre : dots.centres) {
      canvas_.add_circle(view_.to_page(centre), dots.radius_pt);
      canvas_.fill(dots.colour);
    }
  }

  void operator()(const OverlayCircle& circle) {
    canvas_.add_circle(view_.to_page(circle.centre), circle.radius_m * view_.pt_per_m);
    canvas_.stroke(circle.stroke);
  }

  void operator()(const OverlayPose& robot) {
    const Point ahead = unit_vector(robot.pose.theta);
    draw_robot(canvas_, view_.to_page(robot.pose.position()), {ahead.x, -ahead.y}, robot.radius_pt,
               robot.colour);
  }

  void operator()(const OverlayMarker& marker) {
    const Point tip = view_.to_page(marker.at);
    draw_pin(canvas_, tip, marker.colour);
    canvas_.text(tip + Point{5.5, -9.0}, marker.text,
                 {.size_pt = 6.5,
                  .colour = marker.colour,
                  .bold = true,
                  .vertical = Align::kMiddle,
                  .halo = Colour::from_hex(0xFFFFFF, 0.85)});
  }

 private:
  Canvas& canvas_;
  const View& view_;
};

class Sampler {
 public:
  Sampler(Canvas& canvas, const Box& box) : canvas_(canvas), box_(box) {}

  void operator()(const OverlayPath& path) {
    if (path.fill) {
      canvas_.add_box(box_);
      canvas_.fill(*path.fill);
    }
    line(path.stroke);
  }
  void operator()(const OverlaySegments& lines) { line(lines.stroke); }
  void operator()(const OverlayDots& dots) {
    canvas_.add_circle(middle(), std::max(dots.radius_pt, 1.2));
    canvas_.fill(dots.colour);
  }
  void operator()(const OverlayCircle& circle) {
    canvas_.add_circle(middle(), box_.height() / 2);
    canvas_.stroke(circle.stroke);
  }
  void operator()(const OverlayPose& robot) {
    draw_robot(canvas_, middle() - Point{2.0, 0.0}, {1.0, 0.0}, 3.0, robot.colour);
  }
  void operator()(const OverlayMarker& marker) {
    draw_pin(canvas_, middle() + Point{0.0, 6.0}, marker.colour);
  }

 private:
  Point middle() const { return {(box_.min_x + box_.max_x) / 2, (box_.min_y + box_.max_y) / 2}; }
  void line(const Stroke& stroke) {
    canvas_.add_line({box_.min_x, middle().y}, {box_.max_x, middle().y});
    canvas_.stroke(stroke);
  }

  Canvas& canvas_;
  const Box& box_;
};

}  // namespace

void draw_overlay(Canvas& canvas, const View& view, const std::vector<OverlayItem>& items) {
  Drawer drawer(canvas, view);
  for (const auto& item : items) std::visit(drawer, item);
}

// Runs of cells of one colour are one box. Boxes reach a little into the next, so that no seam
// shows where a boundary falls between pixels.
void draw_field(Canvas& canvas, const View& view, const ColourField& field) {
  constexpr double kOverlap_pt = 0.2;
  for (std::size_t i = 0; i < field.colours.size();) {
    const std::size_t row = i / field.columns;
    std::size_t end = i + 1;
    while (end < (row + 1) * field.columns && field.colours[end] == field.colours[i]) ++end;
    if (field.colours[i].opacity > 0.0) {
      const auto at = [&](std::size_t cell, std::size_t above) {
        return view.to_page({field.corner.x + field.cell_m * static_cast<double>(cell),
                             field.corner.y + field.cell_m * static_cast<double>(row + above)});
      };
      const Point low = at(i - row * field.columns, 0);
      const Point high = at(end - row * field.columns, 1);
      canvas.add_box({low.x, high.y - kOverlap_pt, high.x + kOverlap_pt, low.y});
      canvas.fill(field.colours[i]);
    }
    i = end;
  }
}

void draw_sample(Canvas& canvas, const Box& box, const OverlayItem& item) {
  Sampler sampler(canvas, box);
  std::visit(sampler, item);
}

}  // namespace mapwright::converter
