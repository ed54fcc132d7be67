#include "converter/exporters/picture/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace mapwright::converter {
namespace {

constexpr const char* kFontFamily = "DejaVu Sans";

cairo_status_t append_bytes(void* closure, const unsigned char* data, unsigned length) {
  auto& bytes = *static_cast<std::string*>(closure);
  bytes.append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(PictureFormat format, double width_pt, double height_pt,
                              double pixels_per_pt, std::string& bytes) {
  if (format == PictureFormat::kSvg) {
    return cairo_svg_surface_create_for_stream(append_bytes, &bytes, width_pt, height_pt);
  }
  if (format == PictureFormat::kPdf) {
    auto* surface = cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width_pt, height_pt);
    // The library would put today's date; the same map must give the same bytes.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    return surface;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                    static_cast<int>(std::lround(width_pt * pixels_per_pt)),
                                    static_cast<int>(std::lround(height_pt * pixels_per_pt)));
}

bool is_of_pixels(PictureFormat format) {
  return format == PictureFormat::kPng || format == PictureFormat::kWebp;
}

Failure drawing_failure(cairo_status_t status) {
  return {FailureKind::kOutput, std::string("picture: ") + cairo_status_to_string(status)};
}

void select_font(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, kFontFamily, CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size_pt);
}

// Metrics must not depend on the resolution of the page, or labels would move with it.
void use_unhinted_metrics(cairo_t* cairo) {
  auto* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
}

TextSize measure(cairo_t* cairo, const std::string& text, const TextStyle& style) {
  select_font(cairo, style);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return {extents.x_advance, 0.73 * style.size_pt};
}

void set_colour(cairo_t* cairo, const Colour& colour) {
  cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, colour.opacity);
}

double shift(Align align, double extent) {
  switch (align) {
    case Align::kStart:
      return 0.0;
    case Align::kMiddle:
      return extent / 2;
    default:
      return extent;
  }
}

// The SVG writer numbers its surfaces through the whole process; the second picture of a process
// must not differ from the first.
std::string without_surface_numbers(const std::string& svg) {
  constexpr std::string_view kId = "id=\"surface";
  std::string plain;
  plain.reserve(svg.size());
  std::size_t done = 0;
  for (auto at = svg.find(kId); at != svg.npos; at = svg.find(kId, done)) {
    plain.append(svg, done, at + kId.size() - done);
    done = svg.find('"', at + kId.size());
  }
  return plain.append(svg, done);
}

}  // namespace

struct Canvas::Impl {
  PictureFormat format;
  std::string bytes;
  cairo_surface_t* surface;
  cairo_t* cairo;
};

TextSize text_size(std::string_view text, const TextStyle& style) {
  auto* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  auto* cairo = cairo_create(surface);
  use_unhinted_metrics(cairo);
  const TextSize size = measure(cairo, std::string(text), style);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return size;
}

Canvas::Canvas(PictureFormat format, double width_pt, double height_pt, double pixels_per_pt)
    : impl_(std::make_unique<Impl>()) {
  impl_->format = format;
  impl_->surface = make_surface(format, width_pt, height_pt, pixels_per_pt, impl_->bytes);
  impl_->cairo = cairo_create(impl_->surface);
  if (is_of_pixels(format)) cairo_scale(impl_->cairo, pixels_per_pt, pixels_per_pt);
  use_unhinted_metrics(impl_->cairo);
  cairo_set_line_join(impl_->cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_fill_rule(impl_->cairo, CAIRO_FILL_RULE_EVEN_ODD);
  set_colour(impl_->cairo, {1.0, 1.0, 1.0, 1.0});
  cairo_paint(impl_->cairo);
}

Canvas::~Canvas() {
  cairo_destroy(impl_->cairo);
  cairo_surface_destroy(impl_->surface);
}

void Canvas::add_path(std::span<const Point> points, bool closed) {
  if (points.empty()) return;
  cairo_move_to(impl_->cairo, points[0].x, points[0].y);
  for (const Point p : points.subspan(1)) cairo_line_to(impl_->cairo, p.x, p.y);
  if (closed) cairo_close_path(impl_->cairo);
}

void Canvas::add_line(Point a, Point b) {
  cairo_move_to(impl_->cairo, a.x, a.y);
  cairo_line_to(impl_->cairo, b.x, b.y);
}

void Canvas::add_circle(Point centre, double radius_pt) {
  cairo_new_sub_path(impl_->cairo);
  cairo_arc(impl_->cairo, centre.x, centre.y, radius_pt, 0.0, 2.0 * std::numbers::pi);
  cairo_close_path(impl_->cairo);
}

void Canvas::add_box(const Box& box) {
  cairo_rectangle(impl_->cairo, box.min_x, box.min_y, box.width(), box.height());
}

void Canvas::fill(Colour colour, bool keep) {
  set_colour(impl_->cairo, colour);
  if (keep) {
    cairo_fill_preserve(impl_->cairo);
  } else {
    cairo_fill(impl_->cairo);
  }
}

void Canvas::stroke(const Stroke& stroke) {
  set_colour(impl_->cairo, stroke.colour);
  cairo_set_line_width(impl_->cairo, stroke.width_pt);
  cairo_set_line_cap(impl_->cairo,
                     stroke.dash_pt.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(impl_->cairo, stroke.dash_pt.data(), static_cast<int>(stroke.dash_pt.size()), 0.0);
  cairo_stroke(impl_->cairo);
}

void Canvas::text(Point at, std::string_view text, const TextStyle& style) {
  const std::string terminated(text);
  const TextSize size = measure(impl_->cairo, terminated, style);
  cairo_move_to(impl_->cairo, at.x - shift(style.horizontal, size.width_pt),
                at.y + size.height_pt - shift(style.vertical, size.height_pt));
  if (style.halo) {
    cairo_text_path(impl_->cairo, terminated.c_str());
    set_colour(impl_->cairo, *style.halo);
    cairo_set_line_width(impl_->cairo, style.size_pt / 3.5);
    cairo_set_dash(impl_->cairo, nullptr, 0, 0.0);
    cairo_stroke_preserve(impl_->cairo);
    set_colour(impl_->cairo, style.colour);
    cairo_set_fill_rule(impl_->cairo, CAIRO_FILL_RULE_WINDING);
    cairo_fill(impl_->cairo);
    cairo_set_fill_rule(impl_->cairo, CAIRO_FILL_RULE_EVEN_ODD);
    return;
  }
  set_colour(impl_->cairo, style.colour);
  cairo_show_text(impl_->cairo, terminated.c_str());
  cairo_new_path(impl_->cairo);
}

void Canvas::clip(const Box& box) {
  cairo_save(impl_->cairo);
  add_box(box);
  cairo_clip(impl_->cairo);
}

void Canvas::unclip() {
  cairo_restore(impl_->cairo);
}

Result<std::string> Canvas::finish() {
  auto status = cairo_status(impl_->cairo);
  if (impl_->format == PictureFormat::kPng && status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(impl_->surface, append_bytes, &impl_->bytes);
  }
  cairo_surface_finish(impl_->surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(impl_->surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    return tl::unexpected(drawing_failure(status));
  }
  if (impl_->format == PictureFormat::kSvg) return without_surface_numbers(impl_->bytes);
  return impl_->bytes;
}

Result<Pixels> Canvas::pixels() {
  cairo_surface_flush(impl_->surface);
  const auto status = cairo_status(impl_->cairo);
  if (status != CAIRO_STATUS_SUCCESS) return tl::unexpected(drawing_failure(status));
  Pixels pixels{cairo_image_surface_get_width(impl_->surface),
                cairo_image_surface_get_height(impl_->surface),
                {}};
  const auto* data = cairo_image_surface_get_data(impl_->surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(impl_->surface));
  const auto width = static_cast<std::size_t>(pixels.width);
  const auto height = static_cast<std::size_t>(pixels.height);
  pixels.colours.resize(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    std::memcpy(&pixels.colours[y * width], data + y * stride, 4 * width);
  }
  for (auto& colour : pixels.colours) colour &= 0xFFFFFFU;  // the fourth byte is not in use
  return pixels;
}

}  // namespace mapwright::converter
