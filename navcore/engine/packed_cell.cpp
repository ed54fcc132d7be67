#include "navcore/engine/packed_cell.hpp"

#include <initializer_list>
#include <new>
#include <span>
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

// The staircase that stands with the walls, if there is one.
const CellStairs* lone_stairs(const CellWalls& walls) {
  if (walls.stairs.size() != 1 || !walls.stairs[0].low_steps.empty()) return nullptr;
  return &walls.stairs[0];
}

constexpr std::size_t size_in_bytes(std::size_t segments, std::size_t stairs) {
  return sizeof(PackedCell) + stairs * sizeof(PackedStairs) +
         segments * (4 * sizeof(float) + sizeof(std::uint32_t));
}

/// Writes segments run by run.
class SegmentWriter {
 public:
  SegmentWriter(float* floats, std::uint32_t* items) : floats_(floats), items_(items) {}

  SegmentRun write(std::initializer_list<std::span<const CellWall>> parts) {
    SegmentRun run{next_, 0};
    for (const auto& part : parts) run.count += static_cast<std::uint32_t>(part.size());
    float* at = floats_ + std::size_t{4} * run.first;
    for (const auto& part : parts) {
      for (const CellWall& wall : part) {
        at[0] = static_cast<float>(wall.a.x);
        at[std::size_t{1} * run.count] = static_cast<float>(wall.a.y);
        at[std::size_t{2} * run.count] = static_cast<float>(wall.b.x);
        at[std::size_t{3} * run.count] = static_cast<float>(wall.b.y);
        ++at;
        items_[next_++] = wall.item;
      }
    }
    return run;
  }

 private:
  float* floats_;
  std::uint32_t* items_;
  std::uint32_t next_ = 0;
};

}  // namespace

std::size_t packed_size(const CellWalls& walls) {
  return size_in_bytes(segments_of(walls), lone_stairs(walls) ? 0 : walls.stairs.size());
}

std::size_t packed_size(const PackedCell& cell) {
  return size_in_bytes(cell.size, cell.stairs_count);
}

const PackedCell* pack(const CellWalls& walls, std::byte* memory) {
  const CellStairs* const lone = lone_stairs(walls);
  auto* const cell = new (memory) PackedCell;
  cell->size = static_cast<std::uint32_t>(segments_of(walls));
  cell->first_stop = static_cast<std::uint32_t>(walls.two_sided.size());
  cell->first_top = cell->first_stop + static_cast<std::uint32_t>(lone ? lone->stops.size() : 0);
  cell->stairs_count = lone ? 0 : static_cast<std::uint32_t>(walls.stairs.size());
  auto* stairs = reinterpret_cast<PackedStairs*>(cell + 1);
  auto* const floats = reinterpret_cast<float*>(stairs + cell->stairs_count);
  SegmentWriter writer(floats,
                       reinterpret_cast<std::uint32_t*>(floats + std::size_t{4} * cell->size));
  const SegmentRun two_sided = lone ? writer.write({walls.two_sided, lone->stops, lone->tops})
                                    : writer.write({walls.two_sided});
  cell->two_sided_count = two_sided.count;
  cell->one_sided_count = writer.write({walls.one_sided}).count;
  if (lone) return cell;
  for (const CellStairs& s : walls.stairs) {
    *stairs++ = {writer.write({s.tops}), writer.write({s.low_steps}), writer.write({s.stops})};
  }
  return cell;
}

}  // namespace mapwright::navcore::engine
