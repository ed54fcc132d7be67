#include "navcore/engine/packed_cell.hpp"

#include <new>
#include <vector>

namespace mapwright::navcore::engine {
namespace {

std::size_t segments_of(const CellStairs& stairs) {
  return stairs.tops.size() + stairs.low_steps.size() + stairs.stops.size();
}

std::size_t segments_of(const CellWalls& walls) {
  std::size_t segments = walls.two_sided.size() + walls.one_sided.size();
  for (const CellStairs& stairs : walls.stairs) segments += segments_of(stairs);
  return segments;
}

constexpr std::size_t size_in_bytes(std::size_t segments, std::size_t stairs) {
  return sizeof(PackedCell) + stairs * sizeof(PackedStairs) +
         segments * (4 * sizeof(float) + sizeof(std::uint32_t));
}

/// Writes segments run by run.
class SegmentWriter {
 public:
  SegmentWriter(float* floats, std::uint32_t* items) : floats_(floats), items_(items) {}

  void begin(std::size_t count) { run_ = {next_, static_cast<std::uint32_t>(count)}; }
  const SegmentRun& run() const { return run_; }
  std::uint32_t next() const { return next_; }

  void write(const std::vector<CellWall>& walls) {
    for (const CellWall& wall : walls) {
      float* const at = floats_ + std::size_t{4} * run_.first + (next_ - run_.first);
      at[0] = static_cast<float>(wall.a.x);
      at[std::size_t{1} * run_.count] = static_cast<float>(wall.a.y);
      at[std::size_t{2} * run_.count] = static_cast<float>(wall.b.x);
      at[std::size_t{3} * run_.count] = static_cast<float>(wall.b.y);
      items_[next_++] = wall.item;
    }
  }

 private:
  float* floats_;
  std::uint32_t* items_;
  SegmentRun run_;
  std::uint32_t next_ = 0;
};

PackedStairs pack(const CellStairs& stairs, SegmentWriter& writer) {
  PackedStairs packed;
  writer.begin(segments_of(stairs));
  packed.segments = writer.run();
  writer.write(stairs.tops);
  packed.first_low_step = writer.next();
  writer.write(stairs.low_steps);
  packed.first_stop = writer.next();
  writer.write(stairs.stops);
  return packed;
}

}  // namespace

std::size_t packed_size(const CellWalls& walls) {
  return size_in_bytes(segments_of(walls), walls.stairs.size());
}

std::size_t packed_size(const PackedCell& cell) {
  return size_in_bytes(cell.size, cell.stairs_count);
}

const PackedCell* pack(const CellWalls& walls, std::byte* memory) {
  auto* const cell = new (memory) PackedCell;
  cell->size = static_cast<std::uint32_t>(segments_of(walls));
  cell->two_sided_count = static_cast<std::uint32_t>(walls.two_sided.size());
  cell->one_sided_count = static_cast<std::uint32_t>(walls.one_sided.size());
  cell->stairs_count = static_cast<std::uint32_t>(walls.stairs.size());
  auto* stairs = reinterpret_cast<PackedStairs*>(cell + 1);
  auto* const floats = reinterpret_cast<float*>(stairs + walls.stairs.size());
  SegmentWriter writer(floats,
                       reinterpret_cast<std::uint32_t*>(floats + std::size_t{4} * cell->size));
  writer.begin(walls.two_sided.size());
  writer.write(walls.two_sided);
  writer.begin(walls.one_sided.size());
  writer.write(walls.one_sided);
  for (const CellStairs& s : walls.stairs) *stairs++ = pack(s, writer);
  return cell;
}

}  // namespace mapwright::navcore::engine
