// Private to this folder: workspaces that outlive a call.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "navcore/engine/workspace.hpp"

namespace mapwright::navcore::engine {

/// Lends workspaces to threads. A workspace that came back is lent again: it has grown to what
/// scans need, and its memory is warm. Safe to use from many threads.
class WorkspacePool {
 public:
  explicit WorkspacePool(std::size_t padded_rays) : padded_rays_(padded_rays) {}

  /// Calls `work(workspace)`; the workspace is this call's own meanwhile.
  template <class Work>
  void lend(Work&& work) {
    std::unique_ptr<Workspace> workspace = take();
    work(*workspace);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(workspace));
  }

 private:
  std::unique_ptr<Workspace> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Workspace> last = std::move(idle_.back());
        idle_.pop_back();
        return last;
      }
    }
    return std::make_unique<Workspace>(padded_rays_);
  }

  std::size_t padded_rays_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace mapwright::navcore::engine
