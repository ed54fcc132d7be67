#include <algorithm>
#include <cmath>

#include "validators/fix/fixer.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// One that lies beyond the border as a whole may be the one that is wrong.
bool has_an_end_within(const Obstacle& obstacle, const Border& border) {
  return std::any_of(obstacle.segments.begin(), obstacle.segments.end(), [&](const Segment& s) {
    return border.contains(s.a) || border.contains(s.b);
  });
}

}  // namespace

Proposals fix_narrow_border(const FixContext& context) {
  const auto& map = context.document.map;
  const auto text = border_text(context.document);
  if (!text || is_found(context, FindingCode::G102)) return {};
  const Border& border = map.border;
  Box box = border.box();
  for (const std::size_t position : blamed(context, FindingCode::G109)) {
    const Obstacle& obstacle = map.obstacles[position];
    if (!has_an_end_within(obstacle, border)) continue;
    const Box reach = extent(obstacle);
    box.add({reach.min_x, reach.min_y});
    box.add({reach.max_x, reach.max_y});
  }
  const double from[] = {border.left, border.top, border.right, border.bottom};
  const double to[] = {box.min_x, box.max_y, box.max_x, box.min_y};
  Proposal proposal{FindingCode::G109, {}, "", {}};
  for (std::size_t i = 0; i < 4; ++i) {
    if (from[i] == to[i]) continue;
    proposal.edits.push_back(field_edit(text->fields[i], number_text(to[i])));
    proposal.moved_m = std::max(proposal.moved_m, std::abs(to[i] - from[i]));
  }
  if (proposal.edits.empty()) return {};
  proposal.message =
      "the border widened by at most " + metres(proposal.moved_m) + " m, to all that crossed it";
  return {std::move(proposal)};
}

}  // namespace mapwright::validators
