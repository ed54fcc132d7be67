#include "navcore/engine/piece.hpp"

#include <algorithm>
#include <cassert>

namespace mapwright::navcore::engine {
namespace {

constexpr std::uint32_t kNoSlot = UINT32_MAX;

}  // namespace

Piece::Piece(std::span<const Pose> poses, const CellCache& cells, std::vector<std::uint16_t>& marks)
    : poses_(poses), cells_(cells), marks_(marks) {
  assert(poses.size() <= kMost);
  if (marks_.size() < cells.table().slots()) marks_.resize(cells.table().slots());
}

Piece::~Piece() {
  for (std::size_t i = 1; i < used_; ++i) {
    if (slot_[i] != kNoSlot) marks_[slot_[i]] = 0;
  }
}

// What is written for a cell that was visited before is written over for the next one.
inline void Piece::visit(std::size_t pose, const PackedCell* cell, std::uint16_t& mark,
                         std::size_t slot) {
  const bool is_new = mark == 0;
  const auto visited = is_new ? static_cast<std::uint16_t>(used_) : mark;
  mark = visited;
  cell_[used_] = cell;
  slot_[used_] = static_cast<std::uint32_t>(slot);
  visited_[used_].count = 0;
  used_ += is_new ? 1 : 0;
  ++visited_[visited].count;
  visited_by_[pose] = visited;
}

bool Piece::find_cells(const Kernels& kernels) {
  const std::size_t n = poses_.size();
  for (std::size_t i = 0; i < n; ++i) {
    places_.x[i] = poses_[i].x;
    places_.y[i] = poses_[i].y;
    places_.heading[i] = poses_[i].theta.radians();
  }
  kernels.place(cells_.grid(), n, places_);
  const CellTable& table = cells_.table();
  for (std::size_t i = 0; i < n; ++i) {
    if (places_.column[i] == kNowhere) {
      visit(i, cells_.nowhere(), nowhere_mark_, kNoSlot);
      continue;
    }
    const std::size_t slot = table.slot_of({places_.column[i], places_.row[i]});
    const PackedCell* const cell = table.cell_in(slot);
    if (cell == nullptr) return false;
    visit(i, cell, marks_[slot], slot);
  }
  return true;
}

// Starts of cells with few poses come first, then groups.
void Piece::share_out(GroupSize size) {
  for (std::size_t i = 1; i < used_; ++i) {
    Visited& v = visited_[i];
    const std::uint32_t rest = v.count & (size.most - 1);
    const std::uint32_t alone = rest < size.least ? rest : 0;
    v.grouped = v.count - alone;
    v.first_alone = static_cast<std::uint32_t>(alone_count_);
    alone_count_ += alone;
  }
  auto next = static_cast<std::uint32_t>(alone_count_);
  for (std::size_t i = 1; i < used_; ++i) {
    Visited& v = visited_[i];
    v.first_grouped = next;
    groups_[group_count_] = {cell_[i], next, v.grouped};
    group_count_ += v.grouped != 0 ? 1 : 0;
    next += v.grouped;
    v.count = 0;
  }
}

ScanStarts Piece::starts(const Kernels& kernels, const BeamTable& beams) {
  share_out(kernels.group_size(beams));
  const auto n = static_cast<std::uint32_t>(poses_.size());
  for (std::uint32_t scan = 0; scan < n; ++scan) {
    const std::size_t visited = visited_by_[scan];
    Visited& v = visited_[visited];
    const std::uint32_t number = v.count++;
    const bool is_grouped = number < v.grouped;
    const std::uint32_t alone = v.first_alone + number - v.grouped;
    const std::uint32_t start = is_grouped ? v.first_grouped + number : alone;
    alone_[is_grouped ? kMost - 1 : alone] = {cell_[visited], start};
    x_[start] = places_.dx[scan];
    y_[start] = places_.dy[scan];
    cosine_[start] = places_.cosine[scan];
    sine_[start] = places_.sine[scan];
    scan_[start] = scan;
  }
  for (auto* array : {&x_, &y_, &cosine_, &sine_}) {
    std::fill_n(array->begin() + static_cast<std::ptrdiff_t>(n), kBlock, 0.0F);
  }
  return {{alone_.data(), alone_count_},
          {groups_.data(), group_count_},
          x_.data(),
          y_.data(),
          cosine_.data(),
          sine_.data(),
          scan_.data(),
          poses_.data()};
}

}  // namespace mapwright::navcore::engine
