#include <algorithm>

#include "validators/check.hpp"
#include "validators/shape/margins.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

namespace {

// Around the solid outlines that come as near to the border or reach beyond it; others do not
// change the answer. Empty where none of all obstacles comes near on some side.
Box solids_at_border(const CheckContext& context, double limit_m) {
  const Border& border = context.map().border;
  const auto is_near = [&](double margin_m) { return margin_m <= limit_m; };
  Box solids = kEmptyBox;
  const auto all = margins_m(border, context.survey().extent());
  if (!std::all_of(all.begin(), all.end(), is_near)) return solids;
  for (std::size_t i = 0; i < context.map().obstacles.size(); ++i) {
    const Box& box = context.box(i);
    const auto margins = margins_m(border, box);
    if (box.is_empty() || std::none_of(margins.begin(), margins.end(), is_near)) continue;
    if (!context.outline(i).is_counter_clockwise_ring()) continue;
    solids.add({box.min_x, box.min_y});
    solids.add({box.max_x, box.max_y});
  }
  return solids;
}

}  // namespace

// Only solids count: a room seen from inside may fill its border.
void check_border_too_tight(const CheckContext& context, FindingSink& sink) {
  if (!context.has_usable_border()) return;
  const double limit_m = context.options().min_border_margin_m;
  const Box solids = solids_at_border(context, limit_m);
  if (solids.is_empty()) return;
  const auto margins = margins_m(context.map().border, solids);
  // Beyond the border is another finding (G109).
  const bool is_tight = std::all_of(margins.begin(), margins.end(),
                                    [&](double m) { return 0.0 <= m && m <= limit_m; });
  if (!is_tight) return;
  sink.border(FindingCode::G126,
              "the border lies within " + metres(limit_m) +
                  " m of solid obstacles on all four sides; leave room for the robot to go round "
                  "them");
}

}  // namespace mapwright::validators
