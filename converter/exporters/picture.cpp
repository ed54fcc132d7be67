#include "converter/exporters/picture.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/frame.hpp"
#include "converter/exporters/picture/labels.hpp"
#include "converter/exporters/picture/legend.hpp"
#include "converter/exporters/picture/obstacles.hpp"
#include "converter/exporters/picture/overlay.hpp"
#include "converter/exporters/picture/shapes.hpp"
#include "converter/exporters/picture/view.hpp"

namespace mapwright::converter {
namespace {

constexpr double kPixelsPerPt = 2.0;  // 144 pixels an inch
constexpr double kLeft_pt = 38.0;
constexpr double kRight_pt = 14.0;
constexpr double kTop_pt = 14.0;
constexpr double kTitle_pt = 20.0;
constexpr double kBelowPanel_pt = 22.0;
constexpr double kScaleBarRow_pt = 182.0;  // for north arrow and scale bar, beside the legend
constexpr double kBottom_pt = 10.0;
constexpr double kMargin = 0.02;     // of the window's greater side, around border and obstacles
constexpr double kTallest = 2.5;     // height of the panel in widths; higher ones become narrower
constexpr double kWidest_m = 1.0e7;  // a window wider than this is no place on the Earth

Box default_window(const Map& map) {
  Box window = kEmptyBox;
  const Border& border = map.border;
  window.add({std::min(border.left, border.right), std::min(border.bottom, border.top)});
  window.add({std::max(border.left, border.right), std::max(border.bottom, border.top)});
  const Box obstacles = extent(map);
  if (!obstacles.is_empty()) {
    window.add({obstacles.min_x, obstacles.min_y});
    window.add({obstacles.max_x, obstacles.max_y});
  }
  return window.inflated(kMargin * std::max(window.width(), window.height()));
}

Result<Box> checked_window(const Map& map, const PictureOptions& options) {
  const Box window = options.window ? *options.window : default_window(map);
  const bool finite =
      is_finite({window.min_x, window.min_y}) && is_finite({window.max_x, window.max_y});
  if (!finite || window.width() > kWidest_m || window.height() > kWidest_m) {
    return usage_failure("the map's coordinates are no local frame; choose a window to draw");
  }
  if (!(window.width() > 0.0 && window.height() > 0.0)) {
    return usage_failure("the window to draw has no area");
  }
  return window;
}

View make_view(const Box& window, double page_width_pt, double top_pt) {
  const double width_pt = page_width_pt - kLeft_pt - kRight_pt;
  const double pt_per_m =
      std::min(width_pt / window.width(), kTallest * width_pt / window.height());
  const double left = kLeft_pt + (width_pt - window.width() * pt_per_m) / 2;
  return {window,
          {left, top_pt, left + window.width() * pt_per_m, top_pt + window.height() * pt_per_m},
          pt_per_m};
}

void draw_panel(Canvas& canvas, const View& view, const Map& map, const std::vector<Shape>& shapes,
                const Overlay& overlay, const PictureOptions& options) {
  canvas.clip(view.panel);
  draw_ground(canvas, view, map.border);
  if (overlay.field) draw_field(canvas, view, *overlay.field);
  draw_shapes(canvas, view, shapes);
  if (options.orientation_ticks) draw_orientation_ticks(canvas, view, shapes);
  draw_border(canvas, view, map.border);
  draw_overlay(canvas, view, overlay.items);
  draw_labels(canvas, view, shapes, options.labels);
  canvas.unclip();
  draw_axes(canvas, view);
}

}  // namespace

std::optional<PictureFormat> picture_format(std::string_view path) {
  const auto dot = path.rfind('.');
  if (dot == path.npos) return std::nullopt;
  std::string extension(path.substr(dot + 1));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == "svg") return PictureFormat::kSvg;
  if (extension == "png") return PictureFormat::kPng;
  if (extension == "pdf") return PictureFormat::kPdf;
  return std::nullopt;
}

Result<std::string> draw_picture(const Map& map, const Overlay& overlay,
                                 const PictureOptions& options, PictureFormat format) {
  const auto window = checked_window(map, options);
  if (!window) return tl::unexpected(window.error());

  const double width_pt = options.width_px / kPixelsPerPt;
  const double top_pt = kTop_pt + (options.title.empty() ? 0.0 : kTitle_pt);
  const View view = make_view(*window, width_pt, top_pt);
  const auto shapes = shapes_in_view(map, view);
  const Legend legend(shapes, options, overlay.legend);
  const double legend_width_pt = width_pt - kLeft_pt - kRight_pt - kScaleBarRow_pt;
  const double legend_top_pt = view.panel.max_y + kBelowPanel_pt;
  const double height_pt =
      legend_top_pt + std::max(legend.height_pt(legend_width_pt), 24.0) + kBottom_pt;

  Canvas canvas(format, width_pt, std::ceil(height_pt), kPixelsPerPt);
  if (!options.title.empty()) {
    canvas.text({kLeft_pt, kTop_pt + 9.0}, options.title, {.size_pt = 12.0, .bold = true});
  }
  draw_panel(canvas, view, map, shapes, overlay, options);
  legend.draw(canvas, {kLeft_pt, legend_top_pt}, legend_width_pt);
  draw_scale_bar(canvas, view, {width_pt - kRight_pt - 8.0, legend_top_pt + 9.0});
  if (options.north_deg) {
    draw_north_arrow(canvas, {width_pt - kRight_pt - kScaleBarRow_pt + 16.0, legend_top_pt + 9.0},
                     *options.north_deg);
  }
  return canvas.finish();
}

}  // namespace mapwright::converter
