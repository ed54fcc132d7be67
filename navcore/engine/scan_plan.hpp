// Private to this folder: scans of many poses with one laser.
#pragma once

#include <cstddef>
#include <functional>
#include <shared_mutex>
#include <span>

#include "navcore/engine/cell_cache.hpp"
#include "navcore/engine/kernels.hpp"
#include "navcore/engine/workspace_pool.hpp"

namespace mapwright::navcore::engine {

/// What is prepared for a laser: its rays, and the lists of cells for its height and range. Safe to
/// use from many threads.
class ScanPlan {
 public:
  ScanPlan(const Scene& scene, const LaserModel& laser, double cell_size_m,
           std::size_t cell_memory_bytes);

  const LaserModel& laser() const { return laser_; }
  const ScanSetup& setup() const { return setup_; }
  const CellCache& cells() const { return cells_; }
  std::size_t cell_count() const;
  std::size_t cell_bytes() const;

  /// Does something with the starts of `count` consecutive poses; `first` is the number of the one
  /// with scan 0.
  using Work = std::function<void(std::size_t first, std::size_t count, const ScanStarts& starts,
                                  Workspace& work)>;

  /// Hands all poses to `work`, in pieces, from up to `threads` threads.
  void for_poses(std::span<const Pose> poses, const Kernels& kernels, unsigned threads,
                 const Work& work) const;

 private:
  bool try_piece(std::span<const Pose> poses, std::size_t first, const Kernels& kernels,
                 const Work& work, Workspace& workspace) const;
  void compile_for(std::span<const Pose> poses, unsigned threads) const;

  LaserModel laser_;
  BeamTable beams_;
  ScanSetup setup_;
  mutable WorkspacePool workspaces_;
  mutable std::shared_mutex mutex_;  ///< shared: cells are read; exclusive: cells change
  mutable CellCache cells_;
};

}  // namespace mapwright::navcore::engine
