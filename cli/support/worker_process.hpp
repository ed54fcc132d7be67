// The child's side of worker_pool.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "cli/support/worker_pool.hpp"

namespace mapwright::cli {

// First byte of an answer.
inline constexpr char kDoneMark = 'D';
inline constexpr char kFailedMark = 'F';
inline constexpr char kOutOfMemoryMark = 'M';

/// What a forked child does: takes the limits on, works, writes a mark and the text to `answer`,
/// and exits with status 0. Dies when `parent` does.
[[noreturn]] void be_worker(pid_t parent, int answer, const WorkerLimits& limits,
                            const std::function<std::string()>& work);

}  // namespace mapwright::cli
