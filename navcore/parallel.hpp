// Work spread over threads, with the same result for any number of them.
#pragma once

#include <cstddef>
#include <functional>

namespace mapwright::navcore {

/// How many threads `requested` means: 0 is one for each core of the machine.
unsigned thread_count(unsigned requested);

/// Calls `work(begin, end)` on consecutive pieces that together are [0, count), at most `grain`
/// long
/// (> 0), from up to `threads` threads (0: one a core). Which thread takes which piece is not
/// determined: the work on index i must depend on i alone. Returns when all is done; rethrows the
/// first exception of the work.
void parallel_for(std::size_t count, std::size_t grain, unsigned threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace mapwright::navcore
