// Short names for contents: whether two files are the same, which shard a path belongs to.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mapwright::cli {

/// 32 hexadecimal digits (XXH3, 128 bits) that differ when the texts, or how they are cut into
/// pieces, differ. Against accidents, not against people who want two texts to share one.
std::string digest(const std::vector<std::string_view>& pieces);

/// A number that is the same on every machine (XXH3, 64 bits).
std::uint64_t hash64(std::string_view text);

}  // namespace mapwright::cli
