#include "validators/survey/repeated_hash.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <vector>

namespace mapwright::validators {
namespace {

// So many hashes and a table of them stay in the cache nearest to the processor.
constexpr std::size_t kUsualBucket = 1024;

// Hashes sorted by their highest bits, and nothing else: equal ones are in one bucket.
class Buckets {
 public:
  explicit Buckets(std::span<const std::uint64_t> hashes)
      : bits_(1 + static_cast<int>(std::bit_width(hashes.size() / kUsualBucket))),
        ends_(std::size_t{1} << static_cast<unsigned>(bits_)),
        sorted_(hashes.size()) {
    for (const auto hash : hashes) ++ends_[bucket_of(hash)];
    std::exclusive_scan(ends_.begin(), ends_.end(), ends_.begin(), std::size_t{0});
    for (const auto hash : hashes) sorted_[ends_[bucket_of(hash)]++] = hash;
  }

  std::size_t size() const { return ends_.size(); }
  std::span<const std::uint64_t> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span(sorted_).subspan(begin, ends_[i] - begin);
  }

 private:
  std::size_t bucket_of(std::uint64_t hash) const {
    return hash >> static_cast<unsigned>(64 - bits_);
  }

  int bits_;
  std::vector<std::size_t> ends_;  // of the buckets in what is sorted
  std::vector<std::uint64_t> sorted_;
};

// A table with a free slot for each slot taken; which one a hash would like its lowest bits say.
bool some_repeat_in(std::span<const std::uint64_t> bucket, std::vector<std::uint64_t>& table) {
  constexpr std::uint64_t kFree = 0;
  table.assign(std::bit_ceil(2 * bucket.size() + 1), kFree);
  const std::size_t mask = table.size() - 1;
  std::size_t zeros = 0;
  for (const auto hash : bucket) {
    std::size_t at = hash & mask;
    while (table[at] != kFree && table[at] != hash) at = (at + 1) & mask;
    if (hash == kFree ? ++zeros > 1 : table[at] == hash) return true;
    table[at] = hash;
  }
  return false;
}

}  // namespace

bool some_repeat(std::span<const std::uint64_t> hashes) {
  const Buckets buckets(hashes);
  std::vector<std::uint64_t> table;
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    if (some_repeat_in(buckets[i], table)) return true;
  }
  return false;
}

}  // namespace mapwright::validators
