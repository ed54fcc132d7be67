#include <algorithm>

#include "validators/check.hpp"
#include "validators/shape/margins.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

// Only solids count: a room seen from inside may fill its border.
void check_border_too_tight(const CheckContext& context, FindingSink& sink) {
  if (!context.has_usable_border()) return;
  Box solids = kEmptyBox;
  for (const Outline& outline : context.outlines()) {
    if (!outline.is_counter_clockwise_ring()) continue;
    solids.add({outline.box.min_x, outline.box.min_y});
    solids.add({outline.box.max_x, outline.box.max_y});
  }
  if (solids.is_empty()) return;
  const auto margins = margins_m(context.map().border, solids);
  const double limit_m = context.options().min_border_margin_m;
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
