// Pictures one after the other in one file: the only place that knows the WebP library.
#pragma once

#include <memory>
#include <string>

#include "converter/exporters/picture/canvas.hpp"

namespace mapwright::converter {

/// An animated WebP, without loss, that is shown again and again.
class MovingPicture {
 public:
  static constexpr int kMostPixels = 16383;  ///< a side

  explicit MovingPicture(int frame_ms);
  MovingPicture(const MovingPicture&) = delete;
  MovingPicture& operator=(const MovingPicture&) = delete;
  ~MovingPicture();

  /// The next frame; all are of one size.
  void add(const Pixels& pixels);

  /// The file's bytes. Fails (kOutput) where the library failed at anything since the beginning,
  /// or where there is no frame.
  Result<std::string> finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
