// Work done in processes of its own, so that a crash or a hang costs one piece of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace mapwright::cli {

/// What one piece of work may take; 0 is no limit.
struct WorkerLimits {
  double time_s = 0.0;             ///< wall clock
  std::uint64_t memory_bytes = 0;  ///< address space beyond that of the program itself
};

/// How a piece of work ended.
struct WorkerOutcome {
  enum class Kind : std::uint8_t {
    kDone,         ///< `text` is what the work returned
    kTimeLimit,    ///< killed
    kOutOfMemory,  ///< std::bad_alloc, or no memory for a thread
    kFailed,       ///< threw; `text` is what()
    kCrashed,      ///< `text` says by which signal
  };
  Kind kind = Kind::kDone;
  std::string text;
};

/// Calls `work(i)` for each i in [0, count) in a child process of its own, at most `jobs` (> 0) at
/// a time, started in order, and `done(i, outcome)` in this process as each ends, in any order.
///
/// Children are forked: they see all that this process sees, and what they change is lost but for
/// the text they return. They die with this process, however it ends; if `done` throws, they are
/// killed and the exception goes on. Requires that this process runs no other thread.
/// Throws Error (kInternal) where no process can be started.
void run_in_workers(std::size_t count, unsigned jobs, const WorkerLimits& limits,
                    const std::function<std::string(std::size_t)>& work,
                    const std::function<void(std::size_t, WorkerOutcome)>& done);

}  // namespace mapwright::cli
