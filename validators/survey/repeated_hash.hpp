// Private to this folder: whether a hash comes twice.
#pragma once

#include <cstdint>
#include <span>

namespace mapwright::validators {

/// True if two of the hashes are equal. All bits of a hash must be as good as random.
bool some_repeat(std::span<const std::uint64_t> hashes);

}  // namespace mapwright::validators
