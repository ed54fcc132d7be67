// Is it text at all, and is it UTF-8?
#pragma once

#include <cstddef>
#include <string_view>

#include "mapcore/text/defects.hpp"

namespace mapwright::text {

/// Offset of the first block of the text that is no text: one byte in 32 or more are control
/// characters; its size where all of it is text. A text in UTF-16 ends at 0.
std::size_t end_of_text(std::string_view text);

/// Reports what is not text (F102) and what is not UTF-8 (F103, once a record). Returns
/// `end_of_text`.
std::size_t report_encoding(std::string_view text, Defects& defects);

}  // namespace mapwright::text
