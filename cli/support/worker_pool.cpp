#include "cli/support/worker_pool.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "cli/support/error.hpp"
#include "cli/support/worker_process.hpp"

namespace mapwright::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Kind = WorkerOutcome::Kind;

constexpr double kLongestWait_s = 1000.0;

struct Worker {
  std::size_t number = 0;
  pid_t process = -1;
  int answer = -1;  // where it writes
  std::optional<Clock::time_point> deadline;
  std::string text;
};

std::string signal_text(int signal) {
  const char* name = sigabbrev_np(signal);
  const char* what = sigdescr_np(signal);
  return (name == nullptr ? "signal " + std::to_string(signal) : "SIG" + std::string(name)) +
         (what == nullptr ? "" : " (" + std::string(what) + ")");
}

// What is left of a worker that ended by itself.
WorkerOutcome outcome_of(int status, std::string answer) {
  if (WIFSIGNALED(status)) return {Kind::kCrashed, signal_text(WTERMSIG(status))};
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty()) {
    return {Kind::kCrashed, "exit status " + std::to_string(WEXITSTATUS(status))};
  }
  const char mark = answer.front();
  answer.erase(0, 1);
  if (mark == kOutOfMemoryMark) return {Kind::kOutOfMemory, {}};
  return {mark == kDoneMark ? Kind::kDone : Kind::kFailed, std::move(answer)};
}

class Pool {
 public:
  Pool(unsigned jobs, const WorkerLimits& limits,
       const std::function<std::string(std::size_t)>& work,
       const std::function<void(std::size_t, WorkerOutcome)>& done)
      : jobs_(jobs), limits_(limits), work_(work), done_(done) {}
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    for (auto& worker : workers_) kill_and_bury(worker);
  }

  void run(std::size_t count) {
    std::size_t next = 0;
    while (next < count || !workers_.empty()) {
      while (next < count && workers_.size() < jobs_ && start(next)) ++next;
      wait();
    }
  }

 private:
  bool start(std::size_t number);
  void wait();
  void listen(Worker& worker, bool& ended);
  int poll_timeout_ms() const;
  static int bury(Worker& worker);
  static void kill_and_bury(Worker& worker);
  void hand_over(std::size_t index, WorkerOutcome outcome);

  std::size_t jobs_;
  WorkerLimits limits_;
  const std::function<std::string(std::size_t)>& work_;
  const std::function<void(std::size_t, WorkerOutcome)>& done_;
  std::vector<Worker> workers_;
};

// False where the system has no process to give now, but some of ours will end.
bool Pool::start(std::size_t number) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    if (!workers_.empty()) return false;
    throw Error(ExitStatus::kInternal, std::string("no pipe: ") + std::strerror(errno));
  }
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) be_worker(parent, pipe[1], limits_, [&] { return work_(number); });
  const int reason = errno;
  ::close(pipe[1]);
  if (child < 0) {
    ::close(pipe[0]);
    if (!workers_.empty()) return false;
    throw Error(ExitStatus::kInternal,
                std::string("no process can be started: ") + std::strerror(reason));
  }
  Worker worker{number, child, pipe[0], std::nullopt, {}};
  if (limits_.time_s > 0.0) {
    const auto span = std::chrono::duration<double>(limits_.time_s);
    worker.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(span);
  }
  workers_.push_back(std::move(worker));
  return true;
}

int Pool::poll_timeout_ms() const {
  double wait_s = kLongestWait_s;
  for (const auto& worker : workers_) {
    if (!worker.deadline) continue;
    wait_s =
        std::min(wait_s, std::chrono::duration<double>(*worker.deadline - Clock::now()).count());
  }
  return static_cast<int>(std::ceil(std::max(0.0, wait_s) * 1000.0));
}

void Pool::wait() {
  std::vector<pollfd> polled;
  for (const auto& worker : workers_) polled.push_back({worker.answer, POLLIN, 0});
  const int ready = ::poll(polled.data(), polled.size(), poll_timeout_ms());
  // From the back, since what ended leaves the list.
  for (std::size_t i = polled.size(); i-- > 0;) {
    bool ended = false;
    if (ready > 0 && polled[i].revents != 0) listen(workers_[i], ended);
    if (ended) {
      const int status = bury(workers_[i]);
      hand_over(i, outcome_of(status, std::move(workers_[i].text)));
    } else if (workers_[i].deadline && Clock::now() >= *workers_[i].deadline) {
      kill_and_bury(workers_[i]);
      hand_over(i, {Kind::kTimeLimit, {}});
    }
  }
}

void Pool::listen(Worker& worker, bool& ended) {
  std::array<char, 1U << 16U> buffer;
  const ssize_t got = ::read(worker.answer, buffer.data(), buffer.size());
  if (got > 0) worker.text.append(buffer.data(), static_cast<std::size_t>(got));
  ended = got == 0 || (got < 0 && errno != EINTR);
}

int Pool::bury(Worker& worker) {
  ::close(worker.answer);
  int status = 0;
  while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void Pool::kill_and_bury(Worker& worker) {
  ::kill(worker.process, SIGKILL);
  bury(worker);
}

// Out of the list first: `done` may throw.
void Pool::hand_over(std::size_t index, WorkerOutcome outcome) {
  const std::size_t number = workers_[index].number;
  workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
  done_(number, std::move(outcome));
}

}  // namespace

void run_in_workers(std::size_t count, unsigned jobs, const WorkerLimits& limits,
                    const std::function<std::string(std::size_t)>& work,
                    const std::function<void(std::size_t, WorkerOutcome)>& done) {
  Pool(jobs, limits, work, done).run(count);
}

}  // namespace mapwright::cli
