#include "cli/support/unified_diff.hpp"

#include <algorithm>
#include <dtl/dtl.hpp>
#include <vector>

namespace mapwright::cli {
namespace {

constexpr std::size_t kContext = 3;

using Lines = std::vector<std::string>;

// A last line without line break differs from the same line with one, and brings its mark along.
Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    if (end == text.npos) {
      lines.push_back(std::string(text) + "\n\\ No newline at end of file");
      break;
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// A line of both texts (' '), of the first ('-') or of the second ('+').
struct Change {
  char kind;
  const std::string* line;
};

std::size_t common_beginning(const Lines& p, const Lines& q) {
  const auto [at, other] = std::mismatch(p.begin(), p.end(), q.begin(), q.end());
  return static_cast<std::size_t>(at - p.begin());
}

std::size_t common_end(const Lines& p, const Lines& q, std::size_t beginning) {
  const std::size_t most = std::min(p.size(), q.size()) - beginning;
  std::size_t count = 0;
  while (count < most && p[p.size() - 1 - count] == q[q.size() - 1 - count]) ++count;
  return count;
}

Lines between(const Lines& lines, std::size_t beginning, std::size_t end) {
  return {lines.begin() + static_cast<std::ptrdiff_t>(beginning),
          lines.end() - static_cast<std::ptrdiff_t>(end)};
}

/// The edit script, line by line; the texts must outlive it.
class Script {
 public:
  Script(const Lines& before, const Lines& after) {
    const std::size_t beginning = common_beginning(before, after);
    const std::size_t end = common_end(before, after, beginning);
    for (std::size_t i = 0; i < beginning; ++i) changes_.push_back({' ', &before[i]});
    add_middle(between(before, beginning, end), between(after, beginning, end), before, after,
               beginning);
    for (std::size_t i = before.size() - end; i < before.size(); ++i) {
      changes_.push_back({' ', &before[i]});
    }
  }

  const std::vector<Change>& changes() const { return changes_; }

 private:
  void add_middle(const Lines& before, const Lines& after, const Lines& all_before,
                  const Lines& all_after, std::size_t beginning) {
    dtl::Diff<std::string, Lines> diff(before, after);
    diff.compose();
    std::size_t p = beginning, q = beginning;
    for (const auto& [line, info] : diff.getSes().getSequence()) {
      const char kind = info.type == dtl::SES_ADD ? '+' : info.type == dtl::SES_DELETE ? '-' : ' ';
      changes_.push_back({kind, kind == '+' ? &all_after[q] : &all_before[p]});
      if (kind != '+') ++p;
      if (kind != '-') ++q;
    }
  }

  std::vector<Change> changes_;
};

/// Writes hunks of changes that are near each other.
class HunkWriter {
 public:
  explicit HunkWriter(const std::vector<Change>& changes) : changes_(changes) {}

  std::string text() {
    for (std::size_t at = next_change(0); at < changes_.size();) {
      const std::size_t begin = at - std::min(at, kContext);
      std::size_t last = at;
      for (at = next_change(at + 1); at < changes_.size() && at - last <= 2 * kContext + 1;
           at = next_change(at + 1)) {
        last = at;
      }
      write(begin, std::min(changes_.size(), last + kContext + 1));
    }
    return std::move(text_);
  }

 private:
  std::size_t next_change(std::size_t at) const {
    while (at < changes_.size() && changes_[at].kind == ' ') ++at;
    return at;
  }

  // "12,7"; of no lines the number of the line before.
  static std::string range(std::size_t lines_before, std::size_t count) {
    const std::string first = std::to_string(count == 0 ? lines_before : lines_before + 1);
    return count == 1 ? first : first + "," + std::to_string(count);
  }

  void pass(std::size_t from, std::size_t to, std::size_t& old_lines, std::size_t& new_lines) {
    for (std::size_t i = from; i < to; ++i) {
      if (changes_[i].kind != '+') ++old_lines;
      if (changes_[i].kind != '-') ++new_lines;
    }
  }

  void write(std::size_t begin, std::size_t end) {
    pass(done_, begin, old_line_, new_line_);
    std::size_t old_count = 0, new_count = 0;
    pass(begin, end, old_count, new_count);
    text_ += "@@ -" + range(old_line_, old_count) + " +" + range(new_line_, new_count) + " @@\n";
    for (std::size_t i = begin; i < end; ++i) {
      text_ += changes_[i].kind + *changes_[i].line + "\n";
    }
    old_line_ += old_count;
    new_line_ += new_count;
    done_ = end;
  }

  const std::vector<Change>& changes_;
  std::string text_;
  std::size_t done_ = 0;
  std::size_t old_line_ = 0, new_line_ = 0;  // lines before `done_`
};

}  // namespace

std::string unified_diff(std::string_view before, std::string_view after,
                         std::string_view before_name, std::string_view after_name) {
  if (before == after) return {};
  const Lines old_lines = lines_of(before), new_lines = lines_of(after);
  const Script script(old_lines, new_lines);
  return "--- " + std::string(before_name) + "\n+++ " + std::string(after_name) + "\n" +
         HunkWriter(script.changes()).text();
}

}  // namespace mapwright::cli
