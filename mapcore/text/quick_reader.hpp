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
///
/// Mostly a segment begins where the one before it ends and has its height and semantic string,
/// written in the same bytes: these are compared and not read again.
class QuickReader {
 public:
  /// `text` must end with a NUL that is not part of it, as the text of a std::string does.
  QuickReader(std::string_view text, MapBuilder& builder, SemanticCache& semantics)
      : text_(text), builder_(builder), semantics_(semantics) {}

  /// Reads records from offset `at` on, where one begins, as far as they end before `end`. Returns
  /// where the first one begins that needs a closer look, or that is not there.
  std::size_t read(std::size_t at, std::size_t end);

 private:
  class Cursor;

  /// The bytes of fields, blanks between and behind them included, and what they mean.
  template <class Value>
  struct Written {
    std::string_view bytes;
    Value value{};
  };
  struct Attributes {
    double height_m = 0.0;
    InOut in_out = InOut::kOutdoor;
    Semantic semantic;
  };

  bool read_segment(const char*& at);
  bool read_attributes(Cursor& cursor);
  bool read_obstacle(const char*& at);
  std::size_t offset(const char* at) const { return static_cast<std::size_t>(at - text_.data()); }

  std::string_view text_;
  MapBuilder& builder_;
  SemanticCache& semantics_;
  const char* end_ = nullptr;        ///< of what is to be read now
  bool follows_ = false;             ///< a record was read right before
  Written<Point> last_end_;          ///< of the segment before
  Written<Attributes> last_;         ///< from its height to its '#'
};

}  // namespace mapwright::text
