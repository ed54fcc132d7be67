#include "converter/exporters/picture.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/frame.hpp"
#include "converter/exporters/picture/labels.hpp"
#include "converter/exporters/picture/legend.hpp"
#include "converter/exporters/picture/moving_picture.hpp"
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
  draw_shapes(canvas, view, shapes, overlay.field ? RampFill::kNone : RampFill::kColoured);
  if (options.orientation_ticks) draw_orientation_ticks(canvas, view, shapes);
  draw_border(canvas, view, map.border);
  draw_overlay(canvas, view, overlay.items);
  draw_labels(canvas, view, shapes, options.labels);
  canvas.unclip();
  draw_axes(canvas, view);
}

/// Where everything goes.
struct Page {
  View view;
  std::vector<Shape> shapes;
  Legend legend;
  double width_pt, height_pt, legend_top_pt, legend_width_pt;
};

Page lay_out(const Map& map, const Box& window, const std::vector<LegendEntry>& legend_entries,
             const PictureOptions& options) {
  const double width_pt = options.width_px / kPixelsPerPt;
  const double top_pt = kTop_pt + (options.title.empty() ? 0.0 : kTitle_pt);
  const View view = make_view(window, width_pt, top_pt);
  auto shapes = shapes_in_view(map, view);
  Legend legend(shapes, options, legend_entries);
  const double legend_width_pt = width_pt - kLeft_pt - kRight_pt - kScaleBarRow_pt;
  const double legend_top_pt = view.panel.max_y + kBelowPanel_pt;
  const double height_pt =
      legend_top_pt + std::max(legend.height_pt(legend_width_pt), 24.0) + kBottom_pt;
  return {view,          std::move(shapes), std::move(legend), width_pt, std::ceil(height_pt),
          legend_top_pt, legend_width_pt};
}

void draw_page(Canvas& canvas, const Page& page, const Map& map, const Overlay& overlay,
               const PictureOptions& options) {
  if (!options.title.empty()) {
    canvas.text({kLeft_pt, kTop_pt + 9.0}, options.title, {.size_pt = 12.0, .bold = true});
  }
  draw_panel(canvas, page.view, map, page.shapes, overlay, options);
  page.legend.draw(canvas, {kLeft_pt, page.legend_top_pt}, page.legend_width_pt);
  draw_scale_bar(canvas, page.view, {page.width_pt - kRight_pt - 8.0, page.legend_top_pt + 9.0});
  if (options.north_deg) {
    draw_north_arrow(canvas,
                     {page.width_pt - kRight_pt - kScaleBarRow_pt + 16.0, page.legend_top_pt + 9.0},
                     *options.north_deg);
  }
}

// What any of them says, in the order in which it is first said.
std::vector<LegendEntry> common_legend(std::span<const Overlay> overlays) {
  std::vector<LegendEntry> all;
  for (const Overlay& overlay : overlays) {
    for (const LegendEntry& entry : overlay.legend) {
      const auto same = [&](const LegendEntry& other) { return other.text == entry.text; };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(entry);
    }
  }
  return all;
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
  if (extension == "webp") return PictureFormat::kWebp;
  return std::nullopt;
}

Result<std::string> draw_picture(const Map& map, const Overlay& overlay,
                                 const PictureOptions& options, PictureFormat format) {
  if (format == PictureFormat::kWebp) return draw_animation(map, {&overlay, 1}, options, 1000);
  const auto window = checked_window(map, options);
  if (!window) return tl::unexpected(window.error());
  const Page page = lay_out(map, *window, overlay.legend, options);
  Canvas canvas(format, page.width_pt, page.height_pt, kPixelsPerPt);
  draw_page(canvas, page, map, overlay, options);
  return canvas.finish();
}

Result<std::string> draw_animation(const Map& map, std::span<const Overlay> overlays,
                                   const PictureOptions& options, int frame_ms) {
  const auto window = checked_window(map, options);
  if (!window) return tl::unexpected(window.error());
  const Page page = lay_out(map, *window, common_legend(overlays), options);
  if (std::max(page.width_pt, page.height_pt) * kPixelsPerPt > MovingPicture::kMostPixels) {
    return usage_failure(
        "WebP holds pictures of at most 16383 pixels a side; choose a smaller one");
  }
  if (overlays.empty()) return usage_failure("there is no frame to draw");
  MovingPicture picture(frame_ms);
  for (const Overlay& overlay : overlays) {
    Canvas canvas(PictureFormat::kWebp, page.width_pt, page.height_pt, kPixelsPerPt);
    draw_page(canvas, page, map, overlay, options);
    const auto pixels = canvas.pixels();
    if (!pixels) return tl::unexpected(pixels.error());
    picture.add(*pixels);
  }
  return picture.finish();
}

}  // namespace mapwright::converter
