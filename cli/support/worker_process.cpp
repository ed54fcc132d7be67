#include "cli/support/worker_process.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <fstream>
#include <new>
#include <string_view>
#include <system_error>

namespace mapwright::cli {
namespace {

// The kernel kills the child when the parent is gone, whatever ended it.
void die_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // gone before the call
}

// An interrupt from the keyboard reaches the whole group; what becomes of it is for the parent to
// say. Its handler, which removes the parent's temporary files, is none of the child's business.
void leave_signals_to_parent() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGQUIT, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
}

// Program and libraries alone take hundreds of megabytes of addresses: the limit comes on top.
void limit_memory(std::uint64_t bytes) {
  if (bytes == 0) return;
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  statm >> pages;
  const rlim_t total = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + bytes;
  const rlimit limit{total, total};
  ::setrlimit(RLIMIT_AS, &limit);
}

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ::_exit(1);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void answer_with(int descriptor, char mark, std::string_view text) {
  write_all(descriptor, {&mark, 1});
  write_all(descriptor, text);
  ::_exit(0);  // no destructors and no flushing: streams and files are the parent's
}

}  // namespace

void be_worker(pid_t parent, int answer, const WorkerLimits& limits,
               const std::function<std::string()>& work) {
  leave_signals_to_parent();
  die_with(parent);
  limit_memory(limits.memory_bytes);
  try {
    answer_with(answer, kDoneMark, work());
  } catch (const std::bad_alloc&) {
    answer_with(answer, kOutOfMemoryMark, {});
  } catch (const std::system_error& error) {
    const bool no_thread = error.code() == std::errc::resource_unavailable_try_again;
    answer_with(answer, no_thread ? kOutOfMemoryMark : kFailedMark, error.what());
  } catch (const std::exception& error) {
    answer_with(answer, kFailedMark, error.what());
  }
}

}  // namespace mapwright::cli
