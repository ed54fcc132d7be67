// Private to this folder: a child process that is spoken to in frames.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// A kind (whose meaning is the two sides' business) and bytes.
struct Frame {
  std::uint8_t kind = 0;
  std::vector<char> bytes;
};

/// One end of the line between parent and child. Owns its descriptor.
class Line {
 public:
  explicit Line(int socket) : socket_(socket) {}
  Line(Line&& other) noexcept;
  Line& operator=(Line&&) = delete;
  ~Line();

  /// False where the other side is gone.
  bool send(std::uint8_t kind, std::span<const char> bytes) const;
  /// Waits for a frame; false where the other side is gone. `frame` keeps its memory.
  bool receive(Frame& frame) const;
  /// True once something can be received (the end, too), false after `milliseconds`.
  bool wait(int milliseconds) const;

 private:
  int socket_;
};

/// What a child may use before it is ended. Both times count from its last sign of life.
struct ChildLimits {
  double silent_cpu_s = 5.0;    ///< processor time without a frame
  double silent_wall_s = 60.0;  ///< time without a frame, whatever it waits for
  std::uint64_t memory_bytes = std::uint64_t{2} << 30U;
};

class ChildProcess {
 public:
  /// Forks a child that does `work` and ends. It has no standard output or error, ends with its
  /// parent, and leaves no core file. Fails (kInput) where there can be no more processes.
  static Result<std::unique_ptr<ChildProcess>> start(const ChildLimits& limits,
                                                     const std::function<void(const Line&)>& work);
  ChildProcess(pid_t id, const ChildLimits& limits, Line line);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Ends the child, whatever it is doing.
  ~ChildProcess();

  bool send(std::uint8_t kind, std::span<const char> bytes) const;

  /// The next frame; false where the child is no more or was ended for breaking a limit.
  bool receive(Frame& frame);

  /// What became of a child that `receive` found gone: "was killed by signal 11 (…)".
  const std::string& end() const { return end_; }

 private:
  bool wait_for_frame();
  void bury();

  pid_t id_;
  ChildLimits limits_;
  Line line_;
  std::string end_;
};

}  // namespace mapwright::converter
