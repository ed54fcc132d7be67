// Where QuickReader's records go when the obstacles are looked at one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
  explicit ObstacleSink(const ObstacleVisitor& visit) : visit_(visit) {}

  bool wants_more() const { return is_plain_ && is_wanted_; }
  bool is_plain() const { return is_plain_; }

  const Semantic& semantic(std::string_view text) {
    look_at_characters(text);
    return semantics_.get(text);
  }

  void obstacle(const PlainHeader& header) {
    show();
    header_ = header;
    is_under_way_ = true;
    look_at_characters(header.semantic);
  }

  void segment(std::size_t /*offset*/, bool /*follows*/, Point a, Point b, double height_m,
               InOut in_out, const Semantic& semantic) {
    segments_.emplace_back(a, b, height_m, in_out, semantic);
  }

  /// No more records come.
  void finish() { show(); }

 private:
  // Strings of printable ASCII are what most are; all else that is UTF-8 without control characters
  // will do.
  void look_at_characters(std::string_view text) {
    if (is_ascii(text) && count_controls(text) == 0) return;
    if (count_controls(text) > 0 || find_invalid_utf8(text) != text.npos) is_plain_ = false;
  }

  void show() {
    if (!is_under_way_) {
      if (!segments_.empty()) is_plain_ = false;
    } else if (static_cast<std::uint64_t>(header_.declared_segments) != segments_.size()) {
      is_plain_ = false;
    }
    if (is_under_way_ && wants_more()) {
      is_wanted_ =
          visit_({header_.offset, header_.id, header_.shape_type, header_.semantic, segments_});
    }
    segments_.clear();
  }

  const ObstacleVisitor& visit_;
  SemanticCache semantics_;
  PlainHeader header_;
  std::vector<Segment> segments_;  // of the obstacle under way
  bool is_under_way_ = false;      // an obstacle
  bool is_plain_ = true;
  bool is_wanted_ = true;
};

}  // namespace mapwright::text
