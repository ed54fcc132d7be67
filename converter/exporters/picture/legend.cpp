#include "converter/exporters/picture/legend.hpp"

#include <algorithm>

#include "converter/exporters/picture/overlay.hpp"

namespace mapwright::converter {
namespace {

constexpr double kRowHeight_pt = 15.0;
constexpr double kSymbolWidth_pt = 18.0;
constexpr double kSymbolHeight_pt = 8.0;
constexpr double kSymbolGap_pt = 5.0;
constexpr double kEntryGap_pt = 18.0;
const TextStyle kText{.size_pt = 7.5, .vertical = Align::kMiddle};

void draw_kind(Canvas& canvas, const Box& box, const KindStyle& style) {
  if (style.fill.opacity > 0.0) {
    canvas.add_box(box);
    canvas.fill(style.fill);
    canvas.add_box(box);
  } else {
    const double y = (box.min_y + box.max_y) / 2;
    canvas.add_line({box.min_x, y}, {box.max_x, y});
  }
  canvas.stroke({style.line, style.width_pt});
}

void draw_tick_sample(Canvas& canvas, const Box& box) {
  const double y = box.min_y + 2.0;
  const double middle = (box.min_x + box.max_x) / 2;
  const Colour ink = kind_style(ObstacleKind::kBuilding).line;
  canvas.add_line({box.min_x, y}, {box.max_x, y});
  canvas.stroke({ink, 1.1});
  canvas.add_line({middle, y}, {middle, y + 4.0});
  canvas.stroke({ink, 0.7});
}

void draw_indoor_sample(Canvas& canvas, const Box& box) {
  const double y = (box.min_y + box.max_y) / 2;
  canvas.add_line({box.min_x, y}, {box.max_x, y});
  canvas.stroke({kind_style(ObstacleKind::kBuilding).line, 1.0, {3.0, 1.5}});
}

bool has_indoor(const std::vector<Shape>& shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) {
    const auto& segments = shape.obstacle->segments;
    return std::any_of(segments.begin(), segments.end(),
                       [](const Segment& s) { return s.in_out == InOut::kIndoor; });
  });
}

std::string_view meaning(PictureLabels labels) {
  switch (labels) {
    case PictureLabels::kHeights:
      return "height (m)";
    case PictureLabels::kIds:
      return "obstacle id";
    default:
      return "";
  }
}

void draw_number_sample(Canvas& canvas, const Box& box) {
  canvas.text({(box.min_x + box.max_x) / 2, (box.min_y + box.max_y) / 2}, "12",
              {.size_pt = 6.5, .horizontal = Align::kMiddle, .vertical = Align::kMiddle});
}

}  // namespace

Legend::Legend(const std::vector<Shape>& shapes, const PictureOptions& options,
               const std::vector<LegendEntry>& overlay) {
  for (const auto& entry : overlay) {
    add(entry.text,
        [item = entry.sample](Canvas& canvas, const Box& box) { draw_sample(canvas, box, item); });
  }
  for (const auto kind : all_obstacle_kinds()) {
    const auto is_kind = [kind](const Shape& shape) { return shape.kind == kind; };
    if (std::any_of(shapes.begin(), shapes.end(), is_kind)) add_kind(kind);
  }
  if (has_indoor(shapes)) add("indoors", draw_indoor_sample);
  if (options.orientation_ticks && !shapes.empty()) add("free side", draw_tick_sample);
  const auto number = meaning(options.labels);
  if (!number.empty() && !shapes.empty()) add(std::string(number), draw_number_sample);
}

void Legend::add(std::string text, std::function<void(Canvas&, const Box&)> draw_symbol) {
  const double width = kSymbolWidth_pt + kSymbolGap_pt + text_size(text, kText).width_pt;
  entries_.push_back({std::move(text), std::move(draw_symbol), width});
}

void Legend::add_kind(ObstacleKind kind) {
  const KindStyle& style = kind_style(kind);
  add(std::string(to_string(kind)),
      [&style](Canvas& canvas, const Box& box) { draw_kind(canvas, box, style); });
}

std::vector<Legend::Placed> Legend::placed(double width_pt) const {
  std::vector<Placed> all;
  Point at{0.0, 0.0};
  for (const auto& entry : entries_) {
    if (at.x > 0.0 && at.x + entry.width_pt > width_pt) at = {0.0, at.y + kRowHeight_pt};
    all.push_back({&entry, at});
    at.x += entry.width_pt + kEntryGap_pt;
  }
  return all;
}

double Legend::height_pt(double width_pt) const {
  const auto all = placed(width_pt);
  return all.empty() ? 0.0 : all.back().top_left.y + kRowHeight_pt;
}

void Legend::draw(Canvas& canvas, Point top_left, double width_pt) const {
  for (const auto& [entry, offset] : placed(width_pt)) {
    const Point at = top_left + offset;
    const double y = at.y + kRowHeight_pt / 2;
    entry->draw_symbol(
        canvas, {at.x, y - kSymbolHeight_pt / 2, at.x + kSymbolWidth_pt, y + kSymbolHeight_pt / 2});
    canvas.text({at.x + kSymbolWidth_pt + kSymbolGap_pt, y}, entry->text, kText);
  }
}

}  // namespace mapwright::converter
