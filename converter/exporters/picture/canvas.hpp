// A page to draw on: the only place that knows the drawing library.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "converter/exporters/picture.hpp"

namespace mapwright::converter {

enum class Align { kStart, kMiddle, kEnd };

struct TextStyle {
  double size_pt = 8.0;
  Colour colour = Colour::from_hex(0x222222);
  bool bold = false;
  Align horizontal = Align::kStart;
  Align vertical = Align::kEnd;     ///< kEnd: the point is on the base line
  std::optional<Colour> halo = {};  ///< drawn behind the letters to lift them off the map
};

/// Width and height (of a capital letter) on the page.
struct TextSize {
  double width_pt = 0.0;
  double height_pt = 0.0;
};

TextSize text_size(std::string_view text, const TextStyle& style);

/// Rows from the top, pixels from left to right, 0xRRGGBB.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> colours;
};

/// A page of points (1/72 inch), x to the right, y down. Paths are collected by `add_*` and used up
/// by `fill` or `stroke`.
class Canvas {
 public:
  Canvas(PictureFormat format, double width_pt, double height_pt, double pixels_per_pt);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas();

  void add_path(std::span<const Point> points, bool closed);
  void add_line(Point a, Point b);
  void add_circle(Point centre, double radius_pt);
  void add_box(const Box& box);

  /// Even-odd: a ring within a ring is a hole. `keep` leaves the path for a stroke.
  void fill(Colour colour, bool keep = false);
  void stroke(const Stroke& stroke);

  void text(Point at, std::string_view text, const TextStyle& style);

  /// Until `unclip`, nothing is drawn outside of the box.
  void clip(const Box& box);
  void unclip();

  /// Ends the drawing and gives the file's bytes. Errors: the library ran out of memory or limits.
  Result<std::string> finish();

  /// The same for WebP, which is made of pixels by others.
  Result<Pixels> pixels();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
