// Where QuickReader's records go when a map is made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "mapcore/text/map_builder.hpp"
#include "mapcore/text/semantic_cache.hpp"

namespace mapwright::text {

/// An obstacle record without any defect.
struct PlainHeader {
  std::size_t offset = 0;  ///< of the keyword
  std::int64_t id = 0;
  ShapeType shape_type = ShapeType::kClosedPolygon;
  std::size_t shape_type_offset = 0;
  std::int64_t declared_segments = 0;
  std::size_t declared_offset = 0;
  std::string_view semantic;
};

/// Hands them on to the builder that RecordReader's go to as well.
class MapSink {
 public:
  MapSink(MapBuilder& builder, SemanticCache& semantics)
      : builder_(builder), semantics_(semantics) {}

  static bool wants_more() { return true; }

  const Semantic& semantic(std::string_view text) { return semantics_.get(text); }

  /// Where the next obstacle record is read to.
  PlainHeader& next_header() { return plain_; }

  /// It was read.
  void obstacle() {
    const PlainHeader& plain = plain_;
    ObstacleHeader header;
    header.offset = plain.offset;
    header.id = plain.id;
    header.shape_type = plain.shape_type;
    header.shape_type_offset = plain.shape_type_offset;
    header.declared_segments = plain.declared_segments;
    header.declared_offset = plain.declared_offset;
    header.semantic = semantics_.get(plain.semantic);
    builder_.obstacle(std::move(header));
  }

  template <class... Values>
  void segment(std::size_t offset, bool follows, Values&&... values) {
    builder_.segment(offset, follows, std::forward<Values>(values)...);
  }

 private:
  MapBuilder& builder_;
  SemanticCache& semantics_;
  PlainHeader plain_;
};

}  // namespace mapwright::text
