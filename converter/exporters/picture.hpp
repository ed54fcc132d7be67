// Pictures of a map: SVG, PNG, PDF and, where they move, WebP.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/map.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

enum class PictureFormat { kSvg, kPng, kPdf, kWebp };

/// The format a file name asks for by its extension, in upper or lower case.
std::optional<PictureFormat> picture_format(std::string_view path);

/// Red, green, blue and opacity in [0, 1].
struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0, opacity = 1.0;

  /// From 0xRRGGBB.
  static constexpr Colour from_hex(unsigned rgb, double opacity = 1.0) {
    return {((rgb >> 16U) & 255U) / 255.0, ((rgb >> 8U) & 255U) / 255.0, (rgb & 255U) / 255.0,
            opacity};
  }
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// How a line is drawn. Widths and dashes are points (1/72 inch) on the page, whatever the scale.
struct Stroke {
  Colour colour;
  double width_pt = 1.0;
  std::vector<double> dash_pt{};  ///< lengths of dash, gap, dash, …; empty for a solid line
};

// What can be drawn over a map. Places are metres in the map frame.

struct OverlayPath {
  std::vector<Point> points;
  Stroke stroke;
  bool closed = false;
  std::optional<Colour> fill{};
};

/// Lines that have nothing to do with one another, such as the edges of a tree or rays.
struct OverlaySegments {
  std::vector<std::pair<Point, Point>> segments;
  Stroke stroke;
};

struct OverlayDots {
  std::vector<Point> centres;
  double radius_pt = 1.0;
  Colour colour;
};

struct OverlayCircle {
  Point centre;
  double radius_m = 0.0;
  Stroke stroke;
};

/// A robot: a disc with a nose.
struct OverlayPose {
  Pose pose;
  double radius_pt = 4.0;
  Colour colour;
};

/// A pin that points to a place, with a word beside it.
struct OverlayMarker {
  Point at;
  std::string text;
  Colour colour;
};

using OverlayItem = std::variant<OverlayPath, OverlaySegments, OverlayDots, OverlayCircle,
                                 OverlayPose, OverlayMarker>;

/// A line of the legend: an item drawn small (its places do not matter) and what it means.
struct LegendEntry {
  OverlayItem sample;
  std::string text;
};

/// Coloured squares under the obstacles: what a quantity is all over the map.
struct ColourField {
  Point corner;  ///< lower left, map frame
  double cell_m = 1.0;
  std::size_t columns = 0;
  std::vector<Colour> colours;  ///< row by row from the lower left; opacity 0: nothing
};

struct Overlay {
  std::optional<ColourField> field;  ///< drawn first, under the obstacles
  std::vector<OverlayItem> items;    ///< drawn in this order
  std::vector<LegendEntry> legend;
};

/// What is written beside obstacles, where there is room.
enum class PictureLabels { kNone, kHeights, kIds, kNames };

struct PictureOptions {
  std::string title;          ///< empty: none
  std::optional<Box> window;  ///< metres, map frame; nothing: border and all obstacles
  int width_px = 1600;  ///< in [200, 20000]; of PNG and WebP; SVG and PDF are width/2 points wide
  PictureLabels labels = PictureLabels::kHeights;
  bool orientation_ticks = true;    ///< short strokes on the free side of segments
  std::optional<double> north_deg;  ///< direction of true north, counter-clockwise from +x
};

/// Draws the map with axes, grid, scale bar and legend; then the overlay. Returns the bytes of the
/// file; the same input gives the same bytes.
///
/// Errors: a window without area, numbers that are not finite, a picture the library cannot hold.
Result<std::string> draw_picture(const Map& map, const Overlay& overlay,
                                 const PictureOptions& options, PictureFormat format);

/// The same map with one overlay after another, each shown for `frame_ms` (1 to 60000)
/// milliseconds, again and again: an animated WebP without loss of colour. The legend is that of
/// all overlays. Same errors; and a picture more than 16383 pixels wide or high.
Result<std::string> draw_animation(const Map& map, std::span<const Overlay> overlays,
                                   const PictureOptions& options, int frame_ms);

}  // namespace mapwright::converter
