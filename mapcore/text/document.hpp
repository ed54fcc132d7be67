// A map together with the text it was read from, so that findings can name line and column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/map.hpp"
#include "mapcore/text/map_text.hpp"

namespace mapwright {

/// Fields of the records of the map file, in the order they are written (report, appendix A).
enum class ObstacleField : std::uint8_t { kKeyword, kId, kShapeType, kSegmentCount, kSemantic };
enum class SegmentField : std::uint8_t { kAx, kAy, kBx, kBy, kHeight, kInOut, kSemantic };

/// Finds the place of a record's field in the text of a map.
///
/// Keeps 8 bytes per obstacle and 16 per block of the text; the rest is looked up in the text when
/// a finding asks for it. Every place costs one block or some records to find, however long the
/// lines are.
class TextIndex {
 public:
  TextIndex() = default;

  /// An index of the lines alone.
  explicit TextIndex(std::string_view text);

  /// Indexes more lines: those of `text` from where the last call ended (at first 0) up to `end`,
  /// a multiple of kBlockBytes or the end of the text.
  void add_lines(std::string_view text, std::size_t end);

  /// Place of a field of obstacle `obstacle` (0-based position in Map::obstacles).
  TextPlace place(std::string_view text, std::size_t obstacle, ObstacleField field) const;

  /// Place of a field of a segment (0-based position within its obstacle).
  TextPlace place(std::string_view text, std::size_t obstacle, std::size_t segment,
                  SegmentField field) const;

  /// Place of the border record's first number, or of its keyword where it has none; line 1, column
  /// 1 in a map without border.
  TextPlace border_place(std::string_view text) const;

  /// Line and column of a byte offset. A line ends at LF; a UTF-8 byte order mark takes no column.
  TextPlace place_at(std::string_view text, std::size_t offset) const;

  /// Byte offset of a line and column: the inverse of `place_at`. A column beyond its line's end is
  /// the end of the line, a line beyond the text the end of the text.
  std::size_t offset_at(std::string_view text, TextPlace place) const;

  /// Byte offset of a segment's first field.
  std::size_t segment_offset(std::string_view text, std::size_t obstacle,
                             std::size_t segment) const;

  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
  static constexpr std::size_t kBlockBytes = 4096;

  // What the reader fills in.
  std::size_t border_offset = kNowhere;         ///< of the keyword
  std::vector<std::uint64_t> obstacle_offsets;  ///< of the keyword of each obstacle

  /// Notes where a segment of the last obstacle begins: in the order of the file, each of them.
  /// `follows`: it is the record right behind the one noted before (or, as the first one, behind the
  /// obstacle's), with one '#' in between.
  void add_segment(std::size_t segment, std::size_t offset, bool follows) {
    if (!follows || (segment + 1) % kAnchorEvery == 0) add_anchor(segment, offset);
  }

 private:
  // A place from which segments are counted by their '#'.
  struct Anchor {
    std::uint64_t offset;
    std::uint32_t obstacle, segment;
  };
  static constexpr std::size_t kAnchorEvery = 64;

  void add_anchor(std::size_t segment, std::size_t offset);

  std::vector<Anchor> anchors_;
  std::vector<TextPlace> block_places_;  ///< of the first byte of each block
  std::size_t indexed_ = 0;              ///< bytes whose lines are indexed
  TextPlace indexed_place_;              ///< of the byte behind them
};

/// A map as read, with everything that was wrong in its text.
struct MapDocument {
  MapText text;                   ///< as read, byte for byte
  Map map;                        ///< what could be understood
  TextIndex index;                ///< where each part of `map` stands in `text`
  std::vector<Finding> findings;  ///< family F, in the order of the text
};

}  // namespace mapwright
