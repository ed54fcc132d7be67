// Is it text at all, and is it UTF-8?
#pragma once

#include <cstddef>
#include <string_view>

#include "mapcore/text/defects.hpp"

namespace mapwright::text {

/// Offset of the first block of the text that is no text: one byte in 32 or more are control
/// characters; its size where all of it is text. A text in UTF-16 ends at 0.
std::size_t end_of_text(std::string_view text);

/// The same for the blocks from `begin`, a multiple of TextIndex::kBlockBytes, up to `end`; `end`
/// where all of them are text.
std::size_t end_of_text(std::string_view text, std::size_t begin, std::size_t end);

/// The encoding, as iconv(1) calls it, of a text in units of two or four bytes: UTF-16 or UTF-32 by
/// its byte order mark; UTF-16LE or UTF-16BE where every other byte of a start in ASCII is zero.
/// Empty for all others.
std::string_view wide_encoding(std::string_view text);

/// Reports that what begins at `end` is not text (F102).
void report_not_text(std::string_view text, std::size_t end, Defects& defects);

/// Reports what is not UTF-8 from `begin` up to `end`, where records begin or the text ends (F103,
/// once a record).
void report_invalid_utf8(std::string_view text, std::size_t begin, std::size_t end,
                         Defects& defects);

}  // namespace mapwright::text
