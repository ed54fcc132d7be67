#include "mapcore/text/decimal.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

bool says_the_same(const HeaderText& p, const HeaderText& q) {
  for (std::size_t i = 0; i < p.fields.size(); ++i) {
    const auto first = text::read_number(p.fields[i].text);
    const auto second = text::read_number(q.fields[i].text);
    if (first.status != text::NumberStatus::kOk || second.status != text::NumberStatus::kOk ||
        first.value != second.value) {
      return false;
    }
  }
  return true;
}

}  // namespace

Proposals fix_repeated_border(const FixContext& context) {
  const auto& document = context.document;
  const auto first = border_text(document);
  Proposals proposals;
  for (const auto& finding : context.findings) {
    if (finding.code != FindingCode::F105 || !finding.place || !first) continue;
    const auto again =
        header_text_at(document.text, document.index.offset_at(document.text, *finding.place));
    if (!again || !says_the_same(*first, *again)) continue;
    proposals.push_back({finding.code,
                         {},
                         "a second border record removed, which said the same as the first",
                         {removal(document.text, again->begin, again->end)}});
  }
  return proposals;
}

}  // namespace mapwright::validators
