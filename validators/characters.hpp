// Characters nobody can read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mapwright::validators {

/// What in a UTF-8 text cannot be read, in words: a control character, a character without a
/// picture, a replacement character, or letters that were decoded with the wrong encoding ("Ã³" for
/// "ó"). Nothing where all is well. Bytes that are not UTF-8 are passed over (F103 tells of them).
std::optional<std::string> unreadable_part(std::string_view text);

}  // namespace mapwright::validators
