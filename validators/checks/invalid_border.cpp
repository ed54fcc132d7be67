#include "validators/check.hpp"
#include "validators/repairs.hpp"

namespace mapwright::validators {

void check_invalid_border(const CheckContext& context, FindingSink& sink) {
  const Border& border = context.map().border;
  if (context.has_usable_border() || !context.border_was_read()) return;
  const std::string where = !(border.left < border.right) && !(border.bottom < border.top)
                                ? "mx1 < mx4 and my1 > my4"
                            : border.left < border.right ? "my1 > my4"
                                                         : "mx1 < mx4";
  sink.border(FindingCode::G101,
              "the border encloses no area; write the top-left corner first and "
              "the bottom-right one behind it, so that " +
                  where);
  if (auto edit = ordered_border(context.document())) sink.fix(*std::move(edit));
}

}  // namespace mapwright::validators
