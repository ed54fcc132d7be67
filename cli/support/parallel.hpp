// The same work for many items, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace mapwright::cli {

/// Calls `work(i)` for i = 0 … count − 1, each once, on up to `jobs` threads (0: as many as the
/// machine has). Items are begun in order. The first exception, by number of the item, is thrown
/// again when all work is done.
void for_each_item(std::size_t count, std::size_t jobs,
                   const std::function<void(std::size_t)>& work);

}  // namespace mapwright::cli
