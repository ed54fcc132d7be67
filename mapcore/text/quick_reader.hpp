// Reads well-formed records at speed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mapcore/text/map_builder.hpp"
#include "mapcore/text/semantic_cache.hpp"

namespace mapwright::text {

/// Reads records as long as they have no defect whatsoever, and leaves the rest to RecordReader.
/// What it takes, RecordReader would take too, and give the same map.
class QuickReader {
 public:
  /// `text` must end with a NUL that is not part of it, as the text of a std::string does.
  QuickReader(std::string_view text, MapBuilder& builder, SemanticCache& semantics)
      : text_(text), builder_(builder), semantics_(semantics) {}

  /// Reads records from offset `at` on, where one begins. Returns where the first one begins that
  /// needs a closer look.
  std::size_t read(std::size_t at);

 private:
  class Cursor;

  bool read_segment(const char*& at);
  bool read_obstacle(const char*& at);
  std::size_t offset(const char* at) const { return static_cast<std::size_t>(at - text_.data()); }

  std::string_view text_;
  MapBuilder& builder_;
  SemanticCache& semantics_;
  Semantic last_;  ///< of a segment: mostly the next one has the same
};

}  // namespace mapwright::text
