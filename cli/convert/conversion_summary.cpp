#include "cli/convert/conversion_summary.hpp"

#include <functional>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

namespace mapwright::cli {
namespace {

using converter::Ledger;
using converter::LedgerFeature;
using converter::LedgerReason;
using converter::Outcome;

constexpr std::size_t kMostLines = 20;

// Features of a layer that are told the same: the first of them, and how many.
struct Repeated {
  const LedgerFeature* first;
  const LedgerReason* reason;
  std::size_t count;
};

std::string line_of(const Ledger& ledger, const Repeated& told) {
  const auto& source = ledger.sources[told.first->source];
  std::string line =
      source.path + ": layer " + source.layer + ", feature " + std::to_string(told.first->fid);
  if (told.count > 1) line += " and " + std::to_string(told.count - 1) + " more";
  return line + ": " + told.reason->message + " [" +
         std::string(finding_type(told.reason->code).id) + "]";
}

using Which = std::function<bool(const LedgerFeature&, const LedgerReason&)>;

// In the order of the first of each.
std::vector<Repeated> repeated_reasons(const Ledger& ledger, const Which& which) {
  std::vector<Repeated> all;
  std::map<std::tuple<std::size_t, FindingCode, std::string_view>, std::size_t> places;
  for (const auto position : ledger.explained()) {
    const auto& feature = ledger.features[position];
    for (const auto& reason : feature.reasons) {
      if (!which(feature, reason)) continue;
      const auto [place, is_new] =
          places.try_emplace({feature.source, reason.code, reason.message}, all.size());
      if (is_new) all.push_back({&feature, &reason, 0});
      ++all[place->second].count;
    }
  }
  return all;
}

// Returns how many reasons there are.
std::size_t report_reasons(const Ledger& ledger, Console& console, const Which& which) {
  std::size_t count = 0, told = 0, lines = 0;
  for (const auto& repeated : repeated_reasons(ledger, which)) {
    count += repeated.count;
    if (++lines > kMostLines) continue;
    told += repeated.count;
    console.error(line_of(ledger, repeated));
  }
  if (count > told) {
    console.error("… and " + std::to_string(count - told) + " more; --report lists them all");
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
