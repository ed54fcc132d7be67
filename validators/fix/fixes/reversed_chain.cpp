#include <algorithm>
#include <array>

#include "validators/fix/fixer.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Of a wall every segment must face the wrong way: a part of it cannot be turned alone.
bool is_all_wrong(const FixContext& context, std::size_t position) {
  const Obstacle& obstacle = context.document.map.obstacles[position];
  if (is_closed(obstacle.shape_type)) return true;
  const auto wrong = blamed_segments(context, FindingCode::G107, position);
  return wrong.size() == obstacle.segments.size();
}

// Each record takes the fields of its opposite, with the ends changed.
std::vector<OffsetEdit> reversing_edits(const std::vector<SegmentText>& texts) {
  constexpr std::array<std::size_t, 7> kFrom{2, 3, 0, 1, 4, 5, 6};
  std::vector<OffsetEdit> edits;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const auto& opposite = texts[texts.size() - 1 - k];
    for (std::size_t i = 0; i < kFrom.size(); ++i) {
      const auto& field = texts[k].fields[i];
      const auto text = opposite.fields[kFrom[i]].text;
      if (field.text != text) edits.push_back(field_edit(field, std::string(text)));
    }
  }
  return edits;
}

}  // namespace

Proposals fix_reversed_chain(const FixContext& context) {
  Proposals proposals;
  for (const std::size_t position : blamed(context, FindingCode::G107)) {
    const auto texts = segment_texts(context.document, position);
    if (!texts || !is_all_wrong(context, position)) continue;
    const Obstacle& obstacle = context.document.map.obstacles[position];
    proposals.push_back({FindingCode::G107, position, name_of(obstacle) + ": turned round",
                         reversing_edits(*texts)});
  }
  return proposals;
}

}  // namespace mapwright::validators
