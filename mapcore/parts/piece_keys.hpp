// Tokens of obstacles that `crop --cut` made pieces of (docs/parts.md).
#pragma once

#include <string_view>

namespace mapwright::piece_key {

inline constexpr std::string_view kCut = "cut";         ///< the whole, for `merge`
inline constexpr std::string_view kPartOf = "part_of";  ///< id of the first piece

}  // namespace mapwright::piece_key
