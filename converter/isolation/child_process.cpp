#include "converter/isolation/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

namespace mapwright::converter {
namespace {

constexpr int kPatience_ms = 250;  // between two looks at the child's clock
constexpr int kBufferBytes = 1 << 20U;

using Clock = std::chrono::steady_clock;

// A signal must not end the parent because its child is gone.
bool write_all(int socket, const char* bytes, std::size_t size) {
  while (size > 0) {
    const auto done = ::send(socket, bytes, size, MSG_NOSIGNAL);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool read_all(int socket, char* bytes, std::size_t size) {
  while (size > 0) {
    const auto done = ::recv(socket, bytes, size, MSG_WAITALL);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

// Address sanitizers map terabytes, so that a limit would end every child at once.
constexpr bool kLimitsMemory =
#if defined(__SANITIZE_ADDRESS__)
    false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
    false;
#else
    true;
#endif
#else
    true;
#endif

void limit_memory(std::uint64_t bytes) {
  if (!kLimitsMemory) return;
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_DATA, &limit);
}

// The parent's handlers clean up after the parent; the child must neither do that nor outlive it.
void become_a_child(pid_t parent) {
  for (const int number : {SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(number, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

double cpu_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string seconds_text(double seconds) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.3g s", seconds);
  return buffer.data();
}

std::string end_text(int status) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return "was killed by signal " + std::to_string(number) + " (" + ::strsignal(number) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Line::Line(Line&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

Line::~Line() {
  if (socket_ >= 0) ::close(socket_);
}

bool Line::send(std::uint8_t kind, std::span<const char> bytes) const {
  const std::uint64_t head = (static_cast<std::uint64_t>(bytes.size()) << 8U) | kind;
  // What is short goes in one piece: the other side wakes up once.
  std::array<char, 256> piece;
  if (sizeof head + bytes.size() <= piece.size()) {
    std::memcpy(piece.data(), &head, sizeof head);
    std::copy(bytes.begin(), bytes.end(), piece.begin() + sizeof head);
    return write_all(socket_, piece.data(), sizeof head + bytes.size());
  }
  return write_all(socket_, reinterpret_cast<const char*>(&head), sizeof head) &&
         write_all(socket_, bytes.data(), bytes.size());
}

bool Line::receive(Frame& frame) const {
  std::uint64_t head = 0;
  if (!read_all(socket_, reinterpret_cast<char*>(&head), sizeof head)) return false;
  frame.kind = static_cast<std::uint8_t>(head & 0xffU);
  frame.bytes.resize(head >> 8U);
  return read_all(socket_, frame.bytes.data(), frame.bytes.size());
}

bool Line::wait(int milliseconds) const {
  pollfd waiting{socket_, POLLIN, 0};
  return ::poll(&waiting, 1, milliseconds) > 0;
}

Result<std::unique_ptr<ChildProcess>> ChildProcess::start(
    const ChildLimits& limits, const std::function<void(const Line&)>& work) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return input_failure("no more files can be opened");
  }
  Line childs(ends[0]);
  Line parents(ends[1]);
  ::setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &kBufferBytes, sizeof kBufferBytes);
  const pid_t parent = ::getpid();
  const pid_t id = ::fork();
  if (id < 0) return input_failure("no process to read the source can be started");
  if (id == 0) {
    become_a_child(parent);
    { const Line not_mine = std::move(parents); }
    limit_memory(limits.memory_bytes);
    work(childs);
    ::_exit(0);
  }
  return std::make_unique<ChildProcess>(id, limits, std::move(parents));
}

ChildProcess::ChildProcess(pid_t id, const ChildLimits& limits, Line line)
    : id_(id), limits_(limits), line_(std::move(line)) {}

ChildProcess::~ChildProcess() {
  if (id_ <= 0) return;
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

bool ChildProcess::send(std::uint8_t kind, std::span<const char> bytes) const {
  return line_.send(kind, bytes);
}

void ChildProcess::bury() {
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  if (end_.empty()) end_ = end_text(status);
}

bool ChildProcess::wait_for_frame() {
  if (line_.wait(kPatience_ms)) return true;
  const auto since = Clock::now();
  const double cpu_before = cpu_seconds(id_);
  while (!line_.wait(kPatience_ms)) {
    const std::chrono::duration<double> silent = Clock::now() - since;
    const double cpu = cpu_seconds(id_) - cpu_before;
    if (cpu < limits_.silent_cpu_s && silent.count() < limits_.silent_wall_s) continue;
    end_ =
        "was stopped: nothing came of " + seconds_text(std::max(cpu, silent.count())) + " of work";
    ::kill(id_, SIGKILL);
    return false;
  }
  return true;
}

bool ChildProcess::receive(Frame& frame) {
  if (id_ <= 0) return false;
  if (wait_for_frame() && line_.receive(frame)) return true;
  bury();
  return false;
}

}  // namespace mapwright::converter
