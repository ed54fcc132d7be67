// Puts the records of a map file together to a map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mapcore/text/defects.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright::text {

/// An obstacle record, as far as it could be understood.
struct ObstacleHeader {
  std::size_t offset = 0;  ///< of the keyword
  std::optional<std::int64_t> id;
  std::optional<ShapeType> shape_type;
  std::string unknown_shape;  ///< what stands there instead of a shape type 1 to 6
  std::size_t shape_type_offset = 0;
  std::optional<std::int64_t> declared_segments;
  std::size_t declared_offset = 0;
  Semantic semantic;
};

/// Takes records in the order of the file. An obstacle lasts until the next header.
///
/// An obstacle without readable id is left out with its segments: nothing could name it. One
/// without readable shape type is kept, as a closed polygon if its chain closes and as an opened
/// polygon if not. The declared number of segments is compared with the records that are there,
/// readable or not, and used for nothing else.
class MapBuilder {
 public:
  MapBuilder(MapDocument& document, Defects& defects) : document_(document), defects_(defects) {}

  /// Fewest bytes of a segment's record.
  static constexpr std::size_t kShortestSegment = std::string_view("0;0;0;0;0;0;;#").size();

  /// A border record; `border` where its numbers could be read.
  void border(std::size_t offset, const std::optional<Border>& border);

  void obstacle(ObstacleHeader header);

  /// A segment whose record begins at `offset`.
  void segment(std::size_t offset, Segment&& segment) {
    add_segment(offset, false, std::move(segment));
  }

  /// The same, of these values, right behind the '#' of the segment, or of its obstacle's header,
  /// that was handed in before it if `follows`.
  void segment(std::size_t offset, bool follows, const Point& a, const Point& b, double height_m,
               InOut in_out, const Semantic& semantic) {
    add_segment(offset, follows, a, b, height_m, in_out, semantic);
  }

  /// A segment record that could not be understood.
  void unreadable_segment(std::size_t offset);

  /// The subject of the next segment record.
  Subject next_segment() const;

  /// No more records come. `first_record`: where the missing border record is reported.
  void finish(std::size_t first_record);

 private:
  enum class State : std::uint8_t { kBeforeObstacles, kInObstacle, kInLeftOut };

  template <class... Values>
  void add_segment(std::size_t offset, bool follows, Values&&... values) {
    ++records_;
    if (state_ != State::kInObstacle) {
      segment_elsewhere(offset);
      return;
    }
    document_.index.add_segment(segments_.size(), offset, follows);
    segments_.emplace_back(std::forward<Values>(values)...);
  }

  void segment_elsewhere(std::size_t offset);
  void reserve_declared();
  void close_obstacle();
  std::vector<Segment> take_segments();
  void compare_segment_count();
  ShapeType shape_type();
  void report_stray_segments();

  MapDocument& document_;
  Defects& defects_;
  State state_ = State::kBeforeObstacles;
  ObstacleHeader header_;
  std::vector<Segment> segments_;  ///< of the obstacle under way
  std::size_t records_ = 0;        ///< segment records since the header, readable or not
  std::size_t unreadable_ = 0;     ///< of these
  std::optional<std::size_t> first_stray_segment_;
  std::size_t stray_segments_ = 0;
  bool border_is_known_ = false;
};

}  // namespace mapwright::text
