#include "mapcore/text/characters.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

std::string description(std::string_view before, const std::string& after) {
  if (before.empty()) return text::quoted(after) + " written";
  if (after.empty()) return text::quoted(before) + " removed";
  return text::quoted(after) + " written for " + text::quoted(before);
}

// "segment 3 of obstacle 26: ", or the line where nothing else is known.
std::string subject(const Finding& finding) {
  if (finding.obstacle) {
    const std::string obstacle = "obstacle " + std::to_string(*finding.obstacle) + ": ";
    return finding.segment ? "segment " + std::to_string(*finding.segment) + " of " + obstacle
                           : obstacle;
  }
  return finding.place ? "line " + std::to_string(finding.place->line) + ": " : "";
}

}  // namespace

Proposals fix_known_edits(const FixContext& context) {
  const auto& [text, map, index, findings] = context.document;
  Proposals proposals;
  for (const auto& finding : context.findings) {
    if (finding.fix.empty()) continue;
    Proposal proposal;
    proposal.code = finding.code;
    proposal.obstacle = blamed_position(context, finding);
    proposal.message = subject(finding);
    for (const auto& edit : finding.fix) {
      const std::size_t begin = index.offset_at(text, edit.begin);
      const std::size_t end = index.offset_at(text, edit.end);
      if (!proposal.edits.empty()) proposal.message += ", ";
      proposal.message +=
          description(std::string_view(text).substr(begin, end - begin), edit.replacement);
      proposal.edits.push_back({begin, end, edit.replacement});
    }
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

}  // namespace mapwright::validators
