#include "navcore/engine/cell_cache.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "navcore/parallel.hpp"

namespace mapwright::navcore::engine {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 18U;
constexpr double kMostCells = 1e9;  // in either direction

}  // namespace

// -- Arena ------------------------------------------------------------------------------------

void Arena::Release::operator()(std::byte* p) const {
  ::operator delete (p, std::align_val_t{kLine});
}

std::byte* Arena::allocate(std::size_t bytes) {
  bytes = (bytes + kLine - 1) / kLine * kLine;
  if (bytes > left_) {
    const std::size_t chunk = std::max(bytes, kChunkBytes);
    chunks_.emplace_back(
        static_cast<std::byte*>(::operator new (chunk + kLine, std::align_val_t{kLine})));
    next_ = chunks_.back().get();
    left_ = chunk;
    bytes_ += chunk;
  }
  std::byte* const memory = next_;
  next_ += bytes;
  left_ -= bytes;
  return memory;
}

// -- CellTable --------------------------------------------------------------------------------

void CellTable::insert(CellKey key, const PackedCell* cell) {
  if (2 * (size_ + 1) > slots_.size()) grow();
  std::size_t i = home(key);
  while (slots_[i].cell != nullptr) i = (i + 1) & (slots_.size() - 1);
  slots_[i] = {key, cell};
  ++size_;
}

void CellTable::grow() {
  std::vector<Slot> old(2 * slots_.size());
  old.swap(slots_);
  size_ = 0;
  for (const Slot& slot : old) {
    if (slot.cell != nullptr) insert(slot.key, slot.cell);
  }
}

// -- CellCache --------------------------------------------------------------------------------

CellCache::CellCache(const Scene& scene, const Reach& reach, std::size_t budget_bytes)
    : scene_(&scene),
      reach_(reach),
      grid_{reach.cell_size_m, 1.0 / reach.cell_size_m, kMostCells * reach.cell_size_m},
      budget_bytes_(budget_bytes) {
  nowhere_ = pack(CellWalls{}, always_.allocate(packed_size(CellWalls{})));
}

std::size_t CellCache::memory_bytes() const {
  return young_.bytes() + old_.bytes() + always_.bytes();
}

void CellCache::make_room() {
  if (2 * young_.bytes() <= budget_bytes_) return;
  old_ = std::exchange(young_, {});
}

// Lists hold no addresses, so a copy of the bytes is a copy of the list.
bool CellCache::keep_if_old(CellKey key) {
  const PackedCell* const cell = old_.table.find(key);
  if (cell == nullptr) return false;
  const std::size_t bytes = packed_size(*cell);
  std::byte* const memory = young_.arena.allocate(bytes);
  std::memcpy(memory, cell, bytes);
  young_.table.insert(key, std::launder(reinterpret_cast<const PackedCell*>(memory)));
  return true;
}

void CellCache::compile(std::span<const CellKey> keys, unsigned threads) {
  constexpr std::size_t kGrain = 16;
  std::vector<CellWalls> walls(keys.size());
  parallel_for(keys.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      walls[i] = compile_cell(*scene_, reach_, center_of(keys[i]));
    }
  });
  for (std::size_t i = 0; i < keys.size(); ++i) {
    std::byte* const memory = young_.arena.allocate(packed_size(walls[i]));
    young_.table.insert(keys[i], pack(walls[i], memory));
  }
}

void CellCache::compile_missing(std::span<const CellKey> keys, unsigned threads) {
  make_room();
  std::vector<CellKey> missing;
  CellTable asked_for;
  for (const CellKey key : keys) {
    if (young_.table.find(key) != nullptr || keep_if_old(key)) continue;
    if (asked_for.find(key) != nullptr) continue;
    asked_for.insert(key, nowhere_);
    missing.push_back(key);
  }
  compile(missing, threads);
}

}  // namespace mapwright::navcore::engine
