#include "mapcore/text/record_shapes.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

/// A record with too few or too many fields, up to its '#'.
struct Miscounted {
  bool of_segment = false;
  std::size_t first_field = 0;
  std::size_t hash = 0;
};

std::optional<Miscounted> record_at(std::string_view text, std::size_t offset) {
  const std::size_t hash = text.find('#', offset);
  if (hash == text.npos) return std::nullopt;
  const auto first = text::field_at(text, offset, hash);
  if (text::keyword_of(first.text).empty()) return Miscounted{true, offset, hash};
  if (first.text != "obstacle" || !first.closed) return std::nullopt;
  return Miscounted{false, first.next, hash};
}

// The values before the semantic string: the reader understood them, and read on.
std::size_t values_of(const Miscounted& record) {
  return record.of_segment ? 6 : 3;
}

bool holds_values(std::string_view text, const Miscounted& record) {
  const text::FieldWalker walker(text, record.first_field, record.hash);
  return record.of_segment ? text::holds_segment_values(walker)
                           : text::holds_obstacle_values(walker);
}

std::vector<OffsetEdit> edits_for(std::string_view text, const Miscounted& record) {
  text::FieldWalker walker(text, record.first_field, record.hash);
  text::Field last;
  for (std::size_t i = 0; i < values_of(record); ++i) last = walker.next();
  if (skip_blanks(text, walker.at()) == record.hash) {
    const std::size_t behind = last.closed ? last.next : last.offset + last.text.size();
    return {{behind, behind, last.closed ? ";" : ";;"}};
  }
  if (text::holds_a_number(walker)) return {};
  std::vector<OffsetEdit> edits;
  for (text::Field part = walker.next(); !walker.done(); part = walker.next()) {
    if (skip_blanks(text, part.next) == record.hash) break;
    edits.push_back({part.next - 1, part.next, ","});
  }
  return edits;
}

}  // namespace

Proposals fix_field_count(const FixContext& context) {
  const std::string_view text = context.document.text;
  Proposals proposals;
  for (const auto& finding : context.findings) {
    if (finding.code != FindingCode::F108 || !finding.place) continue;
    const auto record = record_at(text, context.document.index.offset_at(text, *finding.place));
    if (!record || !holds_values(text, *record)) continue;
    auto edits = edits_for(text, *record);
    if (edits.empty()) continue;
    const bool is_missing = edits.front().begin == edits.front().end;
    proposals.push_back({finding.code,
                         {},
                         is_missing ? "an empty semantic string written where none was"
                                    : "',' written for ';' within a semantic string",
                         std::move(edits)});
  }
  return proposals;
}

}  // namespace mapwright::validators
