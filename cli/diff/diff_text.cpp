#include <ostream>

#include "cli/diff/diff_answer.hpp"
#include "cli/diff/diff_wording.hpp"

namespace mapwright::cli {
namespace {

constexpr std::string_view kReset = "\033[0m";

// Escape sequences of ECMA-48 (SGR), as git colours its diffs.
std::string_view colour_of(std::string_view kind) {
  if (kind == "added") return "\033[32m";
  if (kind == "removed") return "\033[31m";
  return "\033[36m";
}

void write_line(std::ostream& out, std::string_view kind, std::string_view text, bool colour) {
  constexpr std::size_t kKindWidth = 11;
  if (colour) out << colour_of(kind);
  out << kind;
  if (colour) out << kReset;
  out << std::string(kKindWidth - kind.size(), ' ') << text << '\n';
}

}  // namespace

void write_diff_text(std::ostream& out, const DiffAnswer& answer, bool colour) {
  const std::string renumbered = renumbered_line(answer);
  if (answer.same() && renumbered.empty()) return;
  out << "--- " << answer.path_before << "\n+++ " << answer.path_after << '\n';
  for (const auto& line : diff_lines(answer)) write_line(out, line.kind, line.text, colour);
  if (!renumbered.empty()) write_line(out, "renumbered", renumbered, colour);
  out << summary_line(answer) << '\n';
}

}  // namespace mapwright::cli
