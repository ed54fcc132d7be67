#include "navcore/engine/scan_plan.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <mutex>
#include <vector>

#include "navcore/parallel.hpp"

namespace mapwright::navcore::engine {
namespace {

// Poses prepared and cast together: their starts stay in the first-level cache.
constexpr std::size_t kPiece = 512;

// Pieces whose missing cells are compiled together: bounds what one call adds beyond the budget.
constexpr std::size_t kGroup = 64;

}  // namespace

/// The starts of a few poses, on the stack.
class ScanPlan::Piece {
 public:
  Piece(std::span<const Pose> poses, const CellCache& cells) : poses_(poses), cells_(cells) {
    assert(poses.size() <= kPiece);
  }

  /// False if some pose's cell has no list yet.
  bool find_cells() {
    const double size = cells_.reach().cell_size_m;
    CellKey last{};
    const PackedCell* cell = nullptr;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const Point p = poses_[i].position();
      if (!has_cell(p, size)) {
        starts_[i].cell = cells_.nowhere();
        continue;
      }
      const CellKey key = cells_.key_of(p);
      if (cell == nullptr || !(key == last)) cell = cells_.find(key);
      if (cell == nullptr) return false;
      last = key;
      starts_[i].cell = cell;
    }
    return true;
  }

  std::span<const ScanStart> starts(const Kernels& kernels) {
    std::array<double, kPiece> heading, cosine, sine;
    const std::size_t n = poses_.size();
    for (std::size_t i = 0; i < n; ++i) heading[i] = poses_[i].theta.radians();
    kernels.turn({heading.data(), n}, cosine.data(), sine.data());
    for (std::size_t i = 0; i < n; ++i) {
      const Point p = poses_[i].position() - starts_[i].cell->center;
      starts_[i].x = static_cast<float>(p.x);
      starts_[i].y = static_cast<float>(p.y);
      starts_[i].cosine = static_cast<float>(cosine[i]);
      starts_[i].sine = static_cast<float>(sine[i]);
      starts_[i].pose = &poses_[i];
    }
    return {starts_.data(), n};
  }

 private:
  std::span<const Pose> poses_;
  const CellCache& cells_;
  std::array<ScanStart, kPiece> starts_;
};

ScanPlan::ScanPlan(const Scene& scene, const LaserModel& laser, double cell_size_m,
                   std::size_t cell_memory_bytes)
    : laser_(laser),
      beams_(laser),
      setup_{&scene, &beams_, laser.height_m},
      cells_(scene, {laser.height_m, laser.max_range_m, cell_size_m}, cell_memory_bytes) {}

std::size_t ScanPlan::cell_count() const {
  const std::shared_lock lock(mutex_);
  return cells_.cells();
}

std::size_t ScanPlan::cell_bytes() const {
  const std::shared_lock lock(mutex_);
  return cells_.memory_bytes();
}

// Requires the lock, in either mode.
bool ScanPlan::try_piece(std::span<const Pose> poses, std::size_t first, const Kernels& kernels,
                         const Work& work, Workspace& workspace) const {
  const std::span<const Pose> own = poses.subspan(first, std::min(kPiece, poses.size() - first));
  Piece piece(own, cells_);
  if (!piece.find_cells()) return false;
  work(first, piece.starts(kernels), workspace);
  return true;
}

// Requires the exclusive lock.
void ScanPlan::compile_for(std::span<const Pose> poses, unsigned threads) const {
  std::vector<CellKey> keys;
  keys.reserve(poses.size());
  for (const Pose& pose : poses) {
    if (has_cell(pose.position(), cells_.reach().cell_size_m)) {
      keys.push_back(cells_.key_of(pose.position()));
    }
  }
  cells_.compile_missing(keys, threads);
}

void ScanPlan::for_poses(std::span<const Pose> poses, const Kernels& kernels, unsigned threads,
                         const Work& work) const {
  const std::size_t pieces = (poses.size() + kPiece - 1) / kPiece;
  std::vector<char> done(pieces, 0);
  const auto try_pieces = [&](std::size_t begin, std::size_t end) {
    // A few turns for each thread, so that the slowest does not keep the others waiting.
    const std::size_t turns = threads == 1 ? 1 : 4 * std::size_t{thread_count(threads)};
    const std::size_t grain = std::max<std::size_t>(1, (end - begin) / turns);
    parallel_for(end - begin, grain, threads, [&](std::size_t from, std::size_t to) {
      Workspace workspace(beams_.padded_rays());
      for (std::size_t i = begin + from; i < begin + to; ++i) {
        if (done[i] == 0) {
          done[i] = try_piece(poses, i * kPiece, kernels, work, workspace) ? 1 : 0;
        }
      }
    });
  };
  {
    const std::shared_lock lock(mutex_);
    try_pieces(0, pieces);
  }
  for (std::size_t begin = 0; begin < pieces; begin += kGroup) {
    const std::size_t end = std::min(pieces, begin + kGroup);
    if (std::find(done.begin() + static_cast<std::ptrdiff_t>(begin),
                  done.begin() + static_cast<std::ptrdiff_t>(end),
                  0) == done.begin() + static_cast<std::ptrdiff_t>(end)) {
      continue;
    }
    const std::unique_lock lock(mutex_);
    const std::size_t first = begin * kPiece;
    compile_for(poses.subspan(first, std::min(poses.size(), end * kPiece) - first), threads);
    try_pieces(begin, end);
  }
}

}  // namespace mapwright::navcore::engine
