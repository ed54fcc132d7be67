#include "converter/exporters/picture/frame.hpp"

#include <algorithm>
#include <cmath>

#include "converter/exporters/picture/obstacles.hpp"
#include "mapcore/angle.hpp"

namespace mapwright::converter {
namespace {

constexpr Colour kPaper = Colour::from_hex(0xFCFBF8);
constexpr Colour kOutside = Colour::from_hex(0xECE9E3);
constexpr Colour kGrid = Colour::from_hex(0xDAD6CE);
constexpr Colour kInk = Colour::from_hex(0x333333);
constexpr double kGridDistance_pt = 45.0;
constexpr double kScaleBar_pt = 130.0;
constexpr double kScaleBarHeight_pt = 3.5;

Box page_box(const View& view, const Border& border) {
  const Point top_left = view.to_page({border.left, border.top});
  const Point bottom_right = view.to_page({border.right, border.bottom});
  return {top_left.x, top_left.y, bottom_right.x, bottom_right.y};
}

// Multiples of a round step within [low, high].
std::vector<double> grid_values(double low, double high, double step) {
  std::vector<double> values;
  const double first = std::ceil(low / step);
  const double count = std::floor(high / step) - first;
  for (int i = 0; i <= count; ++i) values.push_back((first + i) * step);
  return values;
}

// The smallest round step that keeps the lines apart.
double grid_step(const View& view) {
  const double least = kGridDistance_pt / view.pt_per_m;
  const double step = round_step(least);
  return step < least ? round_step(2.5 * step) : step;
}

void draw_grid(Canvas& canvas, const View& view) {
  const double step = grid_step(view);
  for (const double x : grid_values(view.window.min_x, view.window.max_x, step)) {
    canvas.add_line(view.to_page({x, view.window.min_y}), view.to_page({x, view.window.max_y}));
  }
  for (const double y : grid_values(view.window.min_y, view.window.max_y, step)) {
    canvas.add_line(view.to_page({view.window.min_x, y}), view.to_page({view.window.max_x, y}));
  }
  canvas.stroke({kGrid, 0.4});
}

}  // namespace

void draw_ground(Canvas& canvas, const View& view, const Border& border) {
  canvas.add_box(view.panel);
  canvas.fill(kOutside);
  canvas.add_box(page_box(view, border));
  canvas.fill(kPaper);
  draw_grid(canvas, view);
}

void draw_border(Canvas& canvas, const View& view, const Border& border) {
  canvas.add_box(page_box(view, border));
  canvas.stroke({kInk, 0.9, {6.0, 2.0, 1.2, 2.0}});
}

void draw_axes(Canvas& canvas, const View& view) {
  const Box& panel = view.panel;
  const double step = grid_step(view);
  const TextStyle below{
      .size_pt = 7.0, .colour = kInk, .horizontal = Align::kMiddle, .vertical = Align::kStart};
  const TextStyle beside{
      .size_pt = 7.0, .colour = kInk, .horizontal = Align::kEnd, .vertical = Align::kMiddle};
  for (const double x : grid_values(view.window.min_x, view.window.max_x, step)) {
    const double at = view.to_page({x, 0.0}).x;
    canvas.add_line({at, panel.max_y}, {at, panel.max_y + 3.0});
    canvas.text({at, panel.max_y + 5.0}, plain_number(x), below);
  }
  for (const double y : grid_values(view.window.min_y, view.window.max_y, step)) {
    const double at = view.to_page({0.0, y}).y;
    canvas.add_line({panel.min_x - 3.0, at}, {panel.min_x, at});
    canvas.text({panel.min_x - 5.0, at}, plain_number(y), beside);
  }
  canvas.stroke({kInk, 0.6});
  canvas.add_box(panel);
  canvas.stroke({kInk, 0.8});
}

void draw_scale_bar(Canvas& canvas, const View& view, Point right_end) {
  const double length_m = round_step(kScaleBar_pt / view.pt_per_m);
  const double part_pt = length_m * view.pt_per_m / 4;
  const double left = right_end.x - 4.0 * part_pt;
  for (int part = 0; part < 4; ++part) {
    canvas.add_box({left + part * part_pt, right_end.y, left + (part + 1) * part_pt,
                    right_end.y + kScaleBarHeight_pt});
    canvas.fill(part % 2 == 0 ? kInk : Colour::from_hex(0xFFFFFF));
  }
  canvas.add_box({left, right_end.y, right_end.x, right_end.y + kScaleBarHeight_pt});
  canvas.stroke({kInk, 0.6});
  const TextStyle style{.size_pt = 7.0, .colour = kInk, .horizontal = Align::kMiddle};
  const bool in_km = length_m >= 1000.0;
  canvas.text({left, right_end.y - 2.5}, "0", style);
  canvas.text({left + 2.0 * part_pt, right_end.y - 2.5},
              plain_number(length_m / (in_km ? 2000.0 : 2.0)), style);
  canvas.text({right_end.x, right_end.y - 2.5},
              plain_number(in_km ? length_m / 1000.0 : length_m) + (in_km ? " km" : " m"), style);
}

void draw_north_arrow(Canvas& canvas, Point centre, double north_deg) {
  constexpr double kReach_pt = 10.0;
  const Point direction = unit_vector_deg(north_deg);
  const Point north{direction.x, -direction.y};
  draw_arrow(canvas, centre - kReach_pt * north, centre + 0.5 * kReach_pt * north, {kInk, 1.1});
  canvas.text(centre + (kReach_pt + 0.5) * north, "N",
              {.size_pt = 7.5,
               .colour = kInk,
               .bold = true,
               .horizontal = Align::kMiddle,
               .vertical = Align::kMiddle});
}

}  // namespace mapwright::converter
