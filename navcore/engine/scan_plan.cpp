#include "navcore/engine/scan_plan.hpp"

#include <algorithm>
#include <mutex>
#include <vector>

#include "navcore/engine/piece.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::navcore::engine {
namespace {

constexpr std::size_t kPiece = Piece::kMost;

// Pieces whose missing cells are compiled together: bounds what one call adds beyond the budget.
constexpr std::size_t kGroup = 64;

// Rounding of coordinates and of bearings, well beyond what there is of both.
float certainly_behind(const LaserModel& laser, double cell_size_m) {
  constexpr double kMargin_m = 1e-4, kMargin_rad = 2e-6;
  return static_cast<float>(kMargin_m + kMargin_rad * (laser.max_range_m + 2.0 * cell_size_m));
}

}  // namespace

ScanPlan::ScanPlan(const Scene& scene, const LaserModel& laser, double cell_size_m,
                   std::size_t cell_memory_bytes)
    : laser_(laser),
      beams_(laser),
      setup_{&scene, &beams_, laser.height_m, certainly_behind(laser, cell_size_m)},
      workspaces_(beams_.padded_rays()),
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
  Piece piece(own, cells_, workspace.marks);
  if (!piece.find_cells(kernels)) return false;
  work(first, own.size(), piece.starts(kernels, beams_), workspace);
  return true;
}

// Requires the exclusive lock.
void ScanPlan::compile_for(std::span<const Pose> poses, unsigned threads) const {
  std::vector<CellKey> keys;
  keys.reserve(poses.size());
  for (const Pose& pose : poses) {
    if (cells_.has_cell(pose.position())) {
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
      workspaces_.lend([&](Workspace& workspace) {
        for (std::size_t i = begin + from; i < begin + to; ++i) {
          if (done[i] == 0) {
            done[i] = try_piece(poses, i * kPiece, kernels, work, workspace) ? 1 : 0;
          }
        }
      });
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
