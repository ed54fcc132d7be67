#include "cli/support/console.hpp"

#include <chrono>
#include <ostream>
#include <string>

namespace mapwright::cli {
namespace {

constexpr int kBarWidth = 40;

void draw_bar(std::ostream& err, const std::string& what, std::size_t done, std::size_t total) {
  const double share = total == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
  const int filled = static_cast<int>(share * kBarWidth);
  err << '\r' << what << " [" << std::string(filled, '=') << std::string(kBarWidth - filled, ' ')
      << "] " << static_cast<int>(share * 100.0) << " %" << std::flush;
  if (done >= total) err << "\r\033[K" << std::flush;
}

}  // namespace

void Console::error(std::string_view message) {
  err_ << "mapwright: error: " << message << '\n';
}

void Console::complaint(std::string_view line) {
  err_ << line << '\n';
}

void Console::warning(std::string_view message) {
  if (verbosity_ != Verbosity::kQuiet) err_ << "mapwright: warning: " << message << '\n';
}

void Console::note(std::string_view message) {
  if (verbosity_ != Verbosity::kQuiet) err_ << message << '\n';
}

void Console::detail(std::string_view message) {
  if (verbosity_ == Verbosity::kVerbose) err_ << message << '\n';
}

std::function<void(std::size_t, std::size_t)> Console::progress(std::string_view what) {
  if (!err_is_terminal_ || verbosity_ == Verbosity::kQuiet) return [](std::size_t, std::size_t) {};
  using Clock = std::chrono::steady_clock;
  return [this, text = std::string(what), last = Clock::time_point{}](std::size_t done,
                                                                      std::size_t total) mutable {
    const auto now = Clock::now();
    if (done < total && now - last < std::chrono::milliseconds(100)) return;
    last = now;
    draw_bar(err_, text, done, total);
  };
}

}  // namespace mapwright::cli
