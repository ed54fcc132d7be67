#include "cli/convert/conversion_summary.hpp"

#include <functional>
#include <map>

namespace mapwright::cli {
namespace {

using converter::Ledger;
using converter::LedgerFeature;
using converter::LedgerReason;
using converter::Outcome;

constexpr std::size_t kMostLines = 20;

std::string place(const Ledger& ledger, const LedgerFeature& feature) {
  const auto& source = ledger.sources[feature.source];
  return source.path + ": layer " + source.layer + ", feature " + std::to_string(feature.fid);
}

std::size_t report_reasons(
    const Ledger& ledger, Console& console,
    const std::function<bool(const LedgerFeature&, const LedgerReason&)>& which) {
  std::size_t count = 0;
  for (const auto position : ledger.explained()) {
    const auto& feature = ledger.features[position];
    for (const auto& reason : feature.reasons) {
      if (!which(feature, reason) || ++count > kMostLines) continue;
      console.error(place(ledger, feature) + ": " + reason.message + " [" +
                    std::string(finding_type(reason.code).id) + "]");
    }
  }
  if (count > kMostLines) {
    console.error("… and " + std::to_string(count - kMostLines) + " more; --report lists them all");
  }
  return count;
}

// "; C208 ignored_by_rule 255, C210 overhead 124"
std::string reasons_of(const Ledger& ledger, Outcome outcome) {
  std::map<FindingCode, std::size_t> counts;
  for (const auto position : ledger.explained()) {
    const auto& feature = ledger.features[position];
    if (feature.outcome != outcome) continue;
    for (const auto& reason : feature.reasons) ++counts[reason.code];
  }
  std::string text;
  for (const auto& [code, count] : counts) {
    const auto& type = finding_type(code);
    text += (text.empty() ? ": " : ", ") + std::string(type.id) + " " + std::string(type.name) +
            " " + std::to_string(count);
  }
  return text;
}

}  // namespace

void report_conversion(const converter::Conversion& conversion, Console& console) {
  for (const auto& warning : conversion.warnings) console.warning(warning);
  const auto totals = conversion.ledger.totals();
  console.note(std::to_string(totals.features) +
               (totals.features == 1 ? " feature: " : " features: ") +
               std::to_string(totals.written) + " written, " + std::to_string(totals.changed) +
               " changed, " + std::to_string(totals.dropped) + " dropped");
  const auto say = [&](const char* what, Outcome outcome) {
    const std::string reasons = reasons_of(conversion.ledger, outcome);
    if (!reasons.empty()) console.note(what + reasons);
  };
  say("written with remarks", Outcome::kWritten);
  say("changed", Outcome::kChanged);
  say("dropped", Outcome::kDropped);
}

std::size_t report_losses(const Ledger& ledger, Console& console) {
  return report_reasons(ledger, console, [](const auto&, const LedgerReason& reason) {
    return finding_type(reason.code).severity == Severity::kError;
  });
}

std::size_t report_repairs(const Ledger& ledger, Console& console) {
  return report_reasons(ledger, console,
                        [](const LedgerFeature& feature, const LedgerReason& reason) {
                          if (feature.outcome == Outcome::kChanged) return true;
                          return feature.outcome == Outcome::kDropped &&
                                 finding_type(reason.code).severity != Severity::kNote;
                        });
}

}  // namespace mapwright::cli
