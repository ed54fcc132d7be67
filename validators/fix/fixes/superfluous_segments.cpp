#include "mapcore/text/decimal.hpp"
#include "validators/fix/fixer.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

bool declares(const HeaderText& header, std::size_t segments) {
  const auto declared = text::read_integer(header.fields[2].text);
  return declared.status == text::NumberStatus::kOk && declared.value >= 0 &&
         static_cast<std::uint64_t>(declared.value) == segments;
}

std::string counted(std::size_t count, std::string_view what) {
  return std::to_string(count) + (count == 1 ? " segment " : " segments ") + std::string(what) +
         " removed";
}

// Takes the segments away and counts them off.
std::optional<Proposal> without(const FixContext& context, FindingCode code, std::size_t position,
                                std::string_view what) {
  const auto& document = context.document;
  const Obstacle& obstacle = document.map.obstacles[position];
  const auto segments = blamed_segments(context, code, position);
  const auto header = header_text(document, position);
  const std::size_t count = obstacle.segments.size();
  if (!header || segments.size() >= count || !declares(*header, count)) return std::nullopt;
  Proposal proposal{code, position, name_of(obstacle) + ": " + counted(segments.size(), what), {}};
  proposal.edits.push_back(field_edit(header->fields[2], std::to_string(count - segments.size())));
  for (const std::size_t k : segments) {
    const auto text = segment_text(document, position, k);
    if (!text) return std::nullopt;
    proposal.edits.push_back(removal(document.text, text->begin, text->end));
  }
  return proposal;
}

}  // namespace

Proposals fix_superfluous_segments(const FixContext& context) {
  Proposals proposals;
  const auto propose = [&](FindingCode code, std::string_view what) {
    for (const std::size_t position : blamed(context, code)) {
      if (auto proposal = without(context, code, position, what)) {
        proposals.push_back(*std::move(proposal));
      }
    }
  };
  propose(FindingCode::G103, "without length");
  propose(FindingCode::G111, "that stood there twice");
  return proposals;
}

}  // namespace mapwright::validators
