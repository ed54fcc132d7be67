// A PNG file as pixels that tests can ask about.
#pragma once

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace mapwright::test {

/// Pixels of interest, by their place in the image.
class PixelSet {
 public:
  PixelSet(int width, int height) : width_(width), height_(height) {}
  void add(int x, int y) { pixels_.push_back({x, y}); }

  int count() const { return static_cast<int>(pixels_.size()); }
  int min_x() const { return extreme(&Pixel::x).first; }
  int max_x() const { return extreme(&Pixel::x).second; }
  int min_y() const { return extreme(&Pixel::y).first; }
  int max_y() const { return extreme(&Pixel::y).second; }

  /// Those in the upper `share` of the image: the map without its legend.
  PixelSet within_panel(double share) const {
    PixelSet upper(width_, height_);
    for (const Pixel& p : pixels_) {
      if (p.y < share * height_) upper.pixels_.push_back(p);
    }
    return upper;
  }

 private:
  struct Pixel {
    int x, y;
  };
  std::pair<int, int> extreme(int Pixel::*coordinate) const {
    std::pair<int, int> range{1 << 30, -1};
    for (const Pixel& p : pixels_) {
      range.first = std::min(range.first, p.*coordinate);
      range.second = std::max(range.second, p.*coordinate);
    }
    return range;
  }

  int width_, height_;
  std::vector<Pixel> pixels_;
};

class PngImage {
 public:
  explicit PngImage(const std::string& bytes) {
    Reader reader{&bytes, 0};
    auto* surface = cairo_image_surface_create_from_png_stream(&Reader::read, &reader);
    width_ = cairo_image_surface_get_width(surface);
    height_ = cairo_image_surface_get_height(surface);
    const auto* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    pixels_.resize(static_cast<std::size_t>(width_) * height_);
    for (int y = 0; y < height_; ++y) {
      std::memcpy(&pixels_[static_cast<std::size_t>(y) * width_], data + y * stride,
                  4U * static_cast<unsigned>(width_));
    }
    cairo_surface_destroy(surface);
  }

  /// Pixels 0xRRGGBB, row by row from the top.
  PngImage(int width, int height, std::vector<std::uint32_t> pixels)
      : width_(width), height_(height), pixels_(std::move(pixels)) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// Pixels that are not the same in both; pictures of different height count down to the lower
  /// one.
  PixelSet difference(const PngImage& other) const {
    PixelSet set(width_, height_);
    for (int y = 0; y < std::min(height_, other.height_); ++y) {
      for (int x = 0; x < std::min(width_, other.width_); ++x) {
        if (at(x, y) != other.at(x, y)) set.add(x, y);
      }
    }
    return set;
  }

 private:
  struct Reader {
    const std::string* bytes;
    std::size_t done;
    static cairo_status_t read(void* closure, unsigned char* data, unsigned length) {
      auto& self = *static_cast<Reader*>(closure);
      if (self.done + length > self.bytes->size()) return CAIRO_STATUS_READ_ERROR;
      std::memcpy(data, self.bytes->data() + self.done, length);
      self.done += length;
      return CAIRO_STATUS_SUCCESS;
    }
  };
  std::uint32_t at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)] & 0xFFFFFFU;
  }

  int width_ = 0, height_ = 0;
  std::vector<std::uint32_t> pixels_;
};

}  // namespace mapwright::test
