// The bytes of a map's records, and edits of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/text/document.hpp"
#include "mapcore/text/fields.hpp"

namespace mapwright::validators {

/// Puts `replacement` in the place of the bytes [begin, end).
struct OffsetEdit {
  std::size_t begin = 0, end = 0;
  std::string replacement;
};

/// The text after the edits, which are in order and do not overlap.
std::string edited(std::string_view text, const std::vector<OffsetEdit>& edits);

/// A record whose fields are all closed and which '#' ends, as the grammar has it.
template <std::size_t count>
struct RecordText {
  std::size_t begin = 0;  ///< of the keyword; of a segment's first field
  std::size_t end = 0;    ///< behind the '#'
  std::array<text::Field, count> fields;
};
using SegmentText = RecordText<7>;
using HeaderText = RecordText<4>;  ///< of obstacle and border, behind the keyword

/// Nothing where the record is not as the grammar has it.
std::optional<SegmentText> segment_text(const MapDocument& document, std::size_t obstacle,
                                        std::size_t segment);
std::optional<HeaderText> header_text(const MapDocument& document, std::size_t obstacle);
std::optional<HeaderText> border_text(const MapDocument& document);
/// A border or obstacle record whose keyword stands at `offset`.
std::optional<HeaderText> header_text_at(std::string_view text, std::size_t offset);

/// All segments of an obstacle; nothing if one is not as the grammar has it.
std::optional<std::vector<SegmentText>> segment_texts(const MapDocument& document,
                                                      std::size_t obstacle);

/// Writes another text into a field.
OffsetEdit field_edit(const text::Field& field, std::string replacement);

/// Takes a record away, with its line if it has the line for itself.
OffsetEdit removal(std::string_view text, std::size_t begin, std::size_t end);

/// The number in the fewest digits that read back as the same double.
std::string number_text(double value);

/// White space behind `at`.
std::size_t skip_blanks(std::string_view text, std::size_t at);

}  // namespace mapwright::validators
