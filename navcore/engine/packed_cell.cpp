#include "navcore/engine/packed_cell.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <vector>

namespace mapwright::navcore::engine {
namespace {

std::size_t lanes_of(const std::vector<CellWall>& walls) {
  return padded_to_block(walls.size());
}

std::size_t lanes_of(const CellWalls& walls) {
  std::size_t lanes = lanes_of(walls.two_sided) + lanes_of(walls.one_sided);
  for (const CellStairs& stairs : walls.stairs) {
    lanes += padded_to_block(stairs.tops.size() + stairs.low_steps.size() + stairs.stops.size());
  }
  return lanes;
}

constexpr std::size_t size_in_bytes(std::size_t lanes, std::size_t stairs) {
  const std::size_t bytes = sizeof(PackedCell) +
                            lanes * (4 * sizeof(float) + sizeof(std::uint32_t)) +
                            stairs * sizeof(PackedStairs);
  return (bytes + kLine - 1) / kLine * kLine;
}

/// Fills lanes one run after the other.
class LaneWriter {
 public:
  LaneWriter(float* blocks, std::uint32_t* items) : blocks_(blocks), items_(items) {}

  LaneRun write(const std::vector<CellWall>& walls) {
    const std::uint32_t first = next_;
    append(walls);
    return end_run(first);
  }

  PackedStairs write(const CellStairs& stairs) {
    PackedStairs packed;
    const std::uint32_t first = next_;
    append(stairs.tops);
    packed.first_low_step = next_;
    append(stairs.low_steps);
    packed.first_stop = next_;
    append(stairs.stops);
    packed.lanes = end_run(first);
    return packed;
  }

 private:
  void append(const std::vector<CellWall>& walls) {
    for (const CellWall& wall : walls) write(next_++, wall);
  }

  LaneRun end_run(std::uint32_t first) {
    const LaneRun run{first, next_ - first};
    next_ = first + static_cast<std::uint32_t>(padded_to_block(run.count));
    return run;
  }

  void write(std::size_t lane, const CellWall& wall) {
    float* const at = blocks_ + lane / kBlock * (4 * kBlock) + lane % kBlock;
    at[0 * kBlock] = static_cast<float>(wall.a.x);
    at[1 * kBlock] = static_cast<float>(wall.a.y);
    at[2 * kBlock] = static_cast<float>(wall.b.x);
    at[3 * kBlock] = static_cast<float>(wall.b.y);
    items_[lane] = wall.item;
  }

  float* blocks_;
  std::uint32_t* items_;
  std::uint32_t next_ = 0;
};

}  // namespace

std::size_t packed_size(const CellWalls& walls) {
  return size_in_bytes(lanes_of(walls), walls.stairs.size());
}

std::size_t packed_size(const PackedCell& cell) {
  return size_in_bytes(cell.lanes, cell.stairs_count);
}

const PackedCell* pack(const CellWalls& walls, Point center, std::byte* memory) {
  std::memset(memory, 0, packed_size(walls));
  auto* const cell = new (memory) PackedCell;
  const std::size_t lanes = lanes_of(walls);
  auto* const blocks = reinterpret_cast<float*>(memory + sizeof(PackedCell));
  auto* const items = reinterpret_cast<std::uint32_t*>(blocks + 4 * lanes);
  auto* stairs = reinterpret_cast<PackedStairs*>(items + lanes);
  LaneWriter writer(blocks, items);
  cell->center = center;
  cell->lanes = static_cast<std::uint32_t>(lanes);
  cell->two_sided = writer.write(walls.two_sided);
  cell->one_sided = writer.write(walls.one_sided);
  cell->stairs_count = static_cast<std::uint32_t>(walls.stairs.size());
  for (const CellStairs& s : walls.stairs) *stairs++ = writer.write(s);
  return cell;
}

}  // namespace mapwright::navcore::engine
