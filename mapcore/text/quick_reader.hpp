// Reads well-formed records at speed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mapcore/text/field_cursor.hpp"
#include "mapcore/text/map_sink.hpp"
#include "mapcore/text/obstacle_sink.hpp"

namespace mapwright::text {

/// Reads records as long as they have no defect whatsoever, and leaves the rest to RecordReader.
/// What it takes, RecordReader would take too, and give the same map. `Sink` takes the records in
/// their order: MapSink or ObstacleSink.
///
/// Mostly a segment begins where the one before it ends and has its height and semantic string,
/// written in the same bytes: these are compared and not read again.
template <class Sink>
class QuickReader {
 public:
  /// `text` must end with a NUL that is not part of it, as the text of a std::string does.
  QuickReader(std::string_view text, Sink& sink) : text_(text), sink_(sink) {}

  /// Reads records from offset `at` on, where one begins, as far as they end before `end` and the
  /// sink wants more of them. Returns where the first one begins that needs a closer look, or that
  /// is not there.
  std::size_t read(std::size_t at, std::size_t end);

  /// Reads a border record that ends before `end`. Returns the offset behind it; `at` where that
  /// needs a closer look.
  std::size_t read_border(std::size_t at, std::size_t end, Border& border);

 private:
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

  bool read_record(const char*& at);
  template <int kLineBreaks>
  bool read_joined_segment(const char*& at);
  bool read_segment(const char*& at);
  /// Points stay in memory: a processor waits for one that is written in halves and read as a
  /// whole.
  void add_segment(const char* first, const Point& a, const Point& b);
  bool read_attributes(FieldCursor& cursor);
  bool read_obstacle(const char*& at);
  std::size_t offset(const char* at) const { return static_cast<std::size_t>(at - text_.data()); }

  std::string_view text_;
  Sink& sink_;
  const char* end_ = nullptr;  ///< of what is to be read now
  bool follows_ = false;       ///< a record was read right before
  Written<Point> last_end_;    ///< of the segment before
  Written<Attributes> last_;   ///< from its height to its '#'
};

extern template class QuickReader<MapSink>;
extern template class QuickReader<ObstacleSink>;

}  // namespace mapwright::text
