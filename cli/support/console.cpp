#include "cli/support/console.hpp"

#include <chrono>
#include <ostream>
#include <string>

namespace mapwright::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBarWidth = 40;
constexpr std::chrono::milliseconds kRedraw{100};
constexpr double kFirstEstimate_s = 2.0;  // earlier ones are wild

std::string span_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

// From what was done since the first news: what comes before it (opening a file) is done once. Work
// that begins anew, as with the next layer, is judged anew.
class Pace {
 public:
  std::string time_left(Clock::time_point now, std::size_t done, std::size_t total) {
    if (done < last_ || start_ == Clock::time_point{}) {
      start_ = now;
      first_ = done;
    }
    last_ = done;
    const double gone_s = std::chrono::duration<double>(now - start_).count();
    if (done == first_ || gone_s < kFirstEstimate_s) return {};
    const double share = static_cast<double>(total - done) / static_cast<double>(done - first_);
    return ", " + span_text(gone_s * share) + " left";
  }

 private:
  Clock::time_point start_;
  std::size_t first_ = 0, last_ = 0;
};

std::string bar(const std::string& what, std::size_t done, std::size_t total) {
  const double share = total == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
  const int filled = static_cast<int>(share * kBarWidth);
  return what + " [" + std::string(filled, '=') + std::string(kBarWidth - filled, ' ') + "] " +
         std::to_string(static_cast<int>(share * 100.0)) + " %, " + std::to_string(done) + " of " +
         std::to_string(total);
}

}  // namespace

void Console::error(std::string_view message) {
  write_line("mapwright: error: ", message);
}

void Console::complaint(std::string_view line) {
  write_line({}, line);
}

void Console::warning(std::string_view message) {
  if (verbosity_ != Verbosity::kQuiet) write_line("mapwright: warning: ", message);
}

void Console::note(std::string_view message) {
  if (verbosity_ != Verbosity::kQuiet) write_line({}, message);
}

void Console::detail(std::string_view message) {
  if (verbosity_ == Verbosity::kVerbose) write_line({}, message);
}

std::function<void(std::size_t, std::size_t)> Console::progress(std::string_view what) {
  if (!err_is_terminal_ || verbosity_ == Verbosity::kQuiet) return [](std::size_t, std::size_t) {};
  return [this, text = std::string(what), pace = Pace(), last = Clock::time_point{}](
             std::size_t done, std::size_t total) mutable {
    const auto now = Clock::now();
    if (done < total && now - last < kRedraw) return;
    last = now;
    clear_bar();
    if (done >= total) return;
    err_ << bar(text, done, total) << pace.time_left(now, done, total) << std::flush;
    bar_is_drawn_ = true;
  };
}

// A line takes the place of the bar, which is drawn again below it.
void Console::write_line(std::string_view prefix, std::string_view text) {
  clear_bar();
  err_ << prefix << text << '\n';
}

void Console::clear_bar() {
  if (bar_is_drawn_) err_ << "\r\033[K" << std::flush;
  bar_is_drawn_ = false;
}

}  // namespace mapwright::cli
