#include <algorithm>

#include "validators/check.hpp"
#include "validators/shape/margins.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

// Measured against the map's own size too: a wide field around two huts may be meant.
void check_border_too_loose(const CheckContext& context, FindingSink& sink) {
  if (!context.has_usable_border()) return;
  const Box box = context.survey().extent();
  if (box.is_empty()) return;
  const auto margins = margins_m(context.map().border, box);
  const double margin_m = *std::max_element(margins.begin(), margins.end());
  const double limit_m =
      std::max({context.options().max_border_margin_m, box.width(), box.height()});
  if (margin_m <= limit_m) return;
  sink.border(FindingCode::G125, "the border lies " + metres(margin_m) +
                                     " m from the nearest obstacle on one side, more than " +
                                     metres(limit_m) + " m; draw it round what the map shows");
}

}  // namespace mapwright::validators
