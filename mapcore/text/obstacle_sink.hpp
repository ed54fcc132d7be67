// Where QuickReader's records go when the obstacles are looked at one by one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "mapcore/text/byte_counts.hpp"
#include "mapcore/text/map_sink.hpp"
#include "mapcore/text/obstacle_stream.hpp"
#include "mapcore/text/semantic_cache.hpp"

namespace mapwright::text {

/// Puts the segments of one obstacle together, shows it, and takes their memory for the next one.
/// Wants no more once a record does not fit or nobody looks any longer.
class ObstacleSink {
 public:
  ObstacleSink(std::size_t text_bytes, const ObstacleVisitor& visit)
      : text_bytes_(text_bytes), visit_(visit) {}

  bool wants_more() const { return is_plain_ && is_wanted_; }

  const Semantic& semantic(std::string_view text) {
    look_at_characters(text);
    return semantics_.get(text);
  }

  /// Where the next obstacle record is read to: not over the one under way.
  PlainHeader& next_header() { return headers_[1 - current_]; }

  /// It was read.
  void obstacle() {
    show();
    current_ = 1 - current_;
    is_under_way_ = true;
    const PlainHeader& header = headers_[current_];
    look_at_characters(header.semantic);
    const auto declared = static_cast<std::uint64_t>(header.declared_segments);
    if (declared <= text_bytes_ / MapBuilder::kShortestSegment) segments_.reserve(declared);
  }

  void segment(std::size_t /*offset*/, bool /*follows*/, const Point& a, const Point& b,
               double height_m, InOut in_out, const Semantic& semantic) {
    if (count_ == segments_.size()) segments_.emplace_back();
    Segment& segment = segments_[count_++];
    segment.a = a;
    segment.b = b;
    segment.height_m = height_m;
    segment.in_out = in_out;
    // Mostly the same stood there before: copies are counted.
    if (!(segment.semantic == semantic)) segment.semantic = semantic;
  }

  /// No more records come.
  void finish() { show(); }

 private:
  // Strings of printable ASCII are what most are; all else that is UTF-8 without control characters
  // will do.
  void look_at_characters(std::string_view text) {
    if (is_printable_ascii(text)) return;
    if (count_controls(text) > 0 || find_invalid_utf8(text) != text.npos) is_plain_ = false;
  }

  const PlainHeader& header() const { return headers_[current_]; }

  void show() {
    if (!is_under_way_) {
      if (count_ > 0) is_plain_ = false;
    } else if (static_cast<std::uint64_t>(header().declared_segments) != count_) {
      is_plain_ = false;
    }
    if (is_under_way_ && wants_more()) {
      is_wanted_ = visit_({header().offset, header().id, header().shape_type, header().semantic,
                           std::span(segments_).first(count_)});
    }
    count_ = 0;
  }

  SemanticCache semantics_;
  std::array<PlainHeader, 2> headers_;
  std::size_t current_ = 0;  // of the obstacle under way
  std::size_t text_bytes_;
  const ObstacleVisitor& visit_;
  std::vector<Segment> segments_;  // the first ones are those of the obstacle under way
  std::size_t count_ = 0;          // of these
  bool is_under_way_ = false;      // an obstacle
  bool is_plain_ = true;
  bool is_wanted_ = true;
};

}  // namespace mapwright::text
