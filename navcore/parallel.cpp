#include "navcore/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace mapwright::navcore {
namespace {

/// Hands out pieces until none is left or one of them failed.
class Pieces {
 public:
  Pieces(std::size_t count, std::size_t grain) : count_(count), grain_(grain) {}

  void work_off(const std::function<void(std::size_t, std::size_t)>& work) {
    while (true) {
      const std::size_t begin = next_.fetch_add(grain_);
      if (begin >= count_) return;
      try {
        work(begin, std::min(count_, begin + grain_));
      } catch (...) {
        stop(std::current_exception());
        return;
      }
    }
  }

  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void stop(std::exception_ptr failure) {
    next_.store(count_);
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
  }

  std::size_t count_;
  std::size_t grain_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

unsigned thread_count(unsigned requested) {
  return requested != 0 ? requested : std::max(1U, std::thread::hardware_concurrency());
}

void parallel_for(std::size_t count, std::size_t grain, unsigned threads,
                  const std::function<void(std::size_t, std::size_t)>& work) {
  assert(grain > 0);
  const std::size_t pieces = count / grain + (count % grain != 0 ? 1 : 0);
  const std::size_t workers = std::min<std::size_t>(thread_count(threads), pieces);
  Pieces work_left(count, grain);
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < workers; ++i)
      helpers.emplace_back([&] { work_left.work_off(work); });
    work_left.work_off(work);
  }
  work_left.rethrow_failure();
}

}  // namespace mapwright::navcore
