// The streams a verb talks to, and how much it says.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace mapwright::cli {

enum class Verbosity { kQuiet, kNormal, kVerbose };

/// Results go to `out`, everything else to `err`.
class Console {
 public:
  Console(std::ostream& out, std::ostream& err, bool err_is_terminal)
      : out_(out), err_(err), err_is_terminal_(err_is_terminal) {}

  std::ostream& out() const { return out_; }
  void set_verbosity(Verbosity verbosity) { verbosity_ = verbosity; }

  /// "mapwright: error: …"; always shown.
  void error(std::string_view message);
  /// A line that names its own place, such as an error in an input; always shown.
  void complaint(std::string_view line);
  /// "mapwright: warning: …"; always shown but with --quiet.
  void warning(std::string_view message);
  /// A line about what was done; not with --quiet.
  void note(std::string_view message);
  /// A line only --verbose asks for.
  void detail(std::string_view message);

  /// Called with (done, total) during long work; draws a bar with counts and the time left on a
  /// terminal, and nothing elsewhere.
  std::function<void(std::size_t, std::size_t)> progress(std::string_view what);

 private:
  void write_line(std::string_view prefix, std::string_view text);
  void clear_bar();

  std::ostream& out_;
  std::ostream& err_;
  bool err_is_terminal_;
  Verbosity verbosity_ = Verbosity::kNormal;
  bool bar_is_drawn_ = false;
};

}  // namespace mapwright::cli
