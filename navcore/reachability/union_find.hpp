// Disjoint sets.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace mapwright::navcore {

/// Disjoint sets of numbers 0 … n − 1 (Tarjan and van Leeuwen: path halving). Of two joined sets
/// the smaller representative stays, so that the answers do not depend on the order of joining.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size = 0) { resize(size); }

  /// Adds sets of one.
  void resize(std::size_t size) {
    const std::size_t old = parents_.size();
    parents_.resize(size);
    std::iota(parents_.begin() + static_cast<long>(old), parents_.end(),
              static_cast<std::uint32_t>(old));
  }

  std::uint32_t find(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  std::uint32_t find(std::uint32_t i) const {
    while (parents_[i] != i) i = parents_[i];
    return i;
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i < j) parents_[j] = i;
    if (j < i) parents_[i] = j;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace mapwright::navcore
