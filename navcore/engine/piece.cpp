#include "navcore/engine/piece.hpp"

#include <algorithm>
#include <cassert>

namespace mapwright::navcore::engine {

Piece::Piece(std::span<const Pose> poses, const CellCache& cells) : poses_(poses), cells_(cells) {
  assert(poses.size() <= kMost);
  in_cell_[0] = {cells.nowhere(), 0, 0};
  center_[0] = {};
}

// A piece's poses lie in few cells when a filter tracks, so most are found here, and only the first
// of a cell in the cache.
inline bool Piece::add(std::size_t pose, CellKey key) {
  std::size_t slot = hash_of(key) & (kSlots - 1);
  while (slots_[slot] != 0 && !(key_[slots_[slot]] == key)) slot = (slot + 1) & (kSlots - 1);
  if (slots_[slot] == 0) {
    const PackedCell* const cell = cells_.find(key);
    if (cell == nullptr) return false;
    key_[used_] = key;
    center_[used_] = cells_.center_of(key);
    in_cell_[used_] = {cell, 0, 0};
    slots_[slot] = static_cast<std::uint16_t>(used_++);
  }
  cell_of_[pose] = slots_[slot];
  ++in_cell_[slots_[slot]].count;
  return true;
}

bool Piece::find_cells() {
  const double size = cells_.reach().cell_size_m;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Point p = poses_[i].position();
    if (has_cell(p, size)) {
      if (!add(i, cells_.key_of(p))) return false;
    } else {
      cell_of_[i] = 0;
      ++in_cell_[0].count;
    }
  }
  return true;
}

void Piece::turn(const Kernels& kernels) {
  std::array<double, kMost> heading;
  const std::size_t n = poses_.size();
  for (std::size_t i = 0; i < n; ++i) heading[i] = poses_[i].theta.radians();
  kernels.turn({heading.data(), n}, cosine_of_.data(), sine_of_.data());
}

ScanStarts Piece::starts(const Kernels& kernels) {
  turn(kernels);
  std::array<std::uint32_t, kMost + 1> next;  // where the next start of a cell goes
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    in_cell_[i].first = next[i] = first;
    first += in_cell_[i].count;
  }
  for (std::uint32_t scan = 0; scan < poses_.size(); ++scan) {
    const std::size_t cell = cell_of_[scan];
    const std::uint32_t start = next[cell]++;
    const Point p = poses_[scan].position() - center_[cell];
    x_[start] = static_cast<float>(p.x);
    y_[start] = static_cast<float>(p.y);
    cosine_[start] = static_cast<float>(cosine_of_[scan]);
    sine_[start] = static_cast<float>(sine_of_[scan]);
    scan_[start] = scan;
  }
  for (auto* array : {&x_, &y_, &cosine_, &sine_}) {
    std::fill_n(array->begin() + static_cast<std::ptrdiff_t>(first), kBlock, 0.0F);
  }
  return {{in_cell_.data(), used_},
          x_.data(),
          y_.data(),
          cosine_.data(),
          sine_.data(),
          scan_.data(),
          poses_.data()};
}

}  // namespace mapwright::navcore::engine
