#include "validators/fix/fixer.hpp"

#include <algorithm>
#include <set>

namespace mapwright::validators {

// Findings name obstacles by id, which may be there twice: the last one that begins before the
// finding's place is meant.
std::optional<std::size_t> blamed_position(const FixContext& context, const Finding& finding) {
  if (!finding.obstacle || !finding.place) return std::nullopt;
  const auto& document = context.document;
  const auto& offsets = document.index.obstacle_offsets;
  const auto offset = document.index.offset_at(document.text, *finding.place);
  const auto next = std::upper_bound(offsets.begin(), offsets.end(), offset);
  if (next == offsets.begin()) return std::nullopt;
  const auto position = static_cast<std::size_t>(next - offsets.begin()) - 1;
  const bool is_named = document.map.obstacles[position].id == *finding.obstacle;
  return is_named ? std::optional(position) : std::nullopt;
}

std::vector<std::size_t> blamed(const FixContext& context, FindingCode code) {
  std::set<std::size_t> positions;
  for (const auto& finding : context.findings) {
    if (finding.code != code) continue;
    if (const auto position = blamed_position(context, finding)) positions.insert(*position);
  }
  return {positions.begin(), positions.end()};
}

std::vector<std::size_t> blamed_segments(const FixContext& context, FindingCode code,
                                         std::size_t position) {
  std::set<std::size_t> segments;
  const auto& obstacle = context.document.map.obstacles[position];
  for (const auto& finding : context.findings) {
    if (finding.code != code || !finding.segment || finding.obstacle != obstacle.id) continue;
    if (blamed_position(context, finding) == position) segments.insert(*finding.segment - 1);
  }
  return {segments.begin(), segments.end()};
}

bool is_found(const FixContext& context, FindingCode code) {
  return std::any_of(context.findings.begin(), context.findings.end(),
                     [code](const Finding& finding) { return finding.code == code; });
}

}  // namespace mapwright::validators
