// What the fields of a damaged record look like.
#pragma once

#include <string_view>

#include "mapcore/text/fields.hpp"

namespace mapwright::text {

bool is_number(std::string_view text);

std::string_view first_word(std::string_view text);
std::string_view last_word(std::string_view text);

/// The last word of a field that is a keyword ("obstacle", ". obstacle", "obstacle 26"), in small
/// letters or large; empty where there is none.
std::string_view keyword_of(std::string_view field);

/// True if the next fields could follow the keyword of an obstacle: three whole numbers and a
/// semantic string.
bool follows_obstacle(FieldWalker walker);

/// True if the next fields could follow the keyword of a border: four numbers.
bool follows_border(FieldWalker walker);

/// True if at least four of the next five fields are numbers: a segment, perhaps with a slip.
bool looks_like_segment(FieldWalker walker);

bool holds_a_number(FieldWalker walker);

/// True if the fields before the semantic string are all well: id, ST and NS of an obstacle, or the
/// five numbers and inOut of a segment.
bool holds_obstacle_values(FieldWalker walker);
bool holds_segment_values(FieldWalker walker);

}  // namespace mapwright::text
