#include "cli/check/summary_table.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <set>
#include <utility>
#include <vector>

namespace mapwright::cli {
namespace {

using validators::Interruption;

constexpr std::size_t kMostCodes = 10;
constexpr std::array<std::string_view, 6> kVerdicts{"pass",       "fail",         "unreadable",
                                                    "time limit", "memory limit", "crash"};

std::string_view verdict_of(const validators::MapReport& report) {
  if (!report.unreadable) return report.passes() ? "pass" : "fail";
  if (report.interruption == Interruption::kNone) return "unreadable";
  return to_string(report.interruption);
}

}  // namespace

void SummaryTable::add(const validators::MapReport& report) {
  ++maps_;
  ++verdicts_[verdict_of(report)];
  std::set<FindingCode> here;
  for (const auto& finding : report.findings) {
    ++codes_[finding.code].findings;
    if (here.insert(finding.code).second) ++codes_[finding.code].maps;
  }
}

void SummaryTable::write(std::ostream& out) const {
  out << "\nverdict          maps\n";
  for (const auto verdict : kVerdicts) {
    const auto found = verdicts_.find(verdict);
    if (found == verdicts_.end()) continue;
    out << std::left << std::setw(12) << verdict << std::right << std::setw(9) << found->second
        << '\n';
  }
  std::vector<std::pair<FindingCode, CodeCount>> codes(codes_.begin(), codes_.end());
  std::stable_sort(codes.begin(), codes.end(), [](const auto& a, const auto& b) {
    return a.second.findings > b.second.findings;
  });
  if (codes.size() > kMostCodes) codes.resize(kMostCodes);
  if (!codes.empty()) out << "\ncode  findings    maps\n";
  for (const auto& [code, count] : codes) {
    const auto& type = finding_type(code);
    out << std::left << std::setw(4) << type.id << std::right << std::setw(10) << count.findings
        << std::setw(8) << count.maps << "  " << type.name << '\n';
  }
}

}  // namespace mapwright::cli
