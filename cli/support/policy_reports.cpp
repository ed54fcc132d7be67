#include "cli/support/policy_reports.hpp"

#include <utility>

#include "cli/support/digest.hpp"
#include "validators/profile/judge.hpp"

namespace mapwright::cli {

std::vector<validators::MapReport> policy_reports(const Policies& policies,
                                                  const std::set<std::string>& used,
                                                  bool every_map_was_seen, validators::Date today) {
  const std::vector<std::string> names(used.begin(), used.end());
  std::vector<validators::MapReport> reports;
  for (const auto& [path, policy] : policies) {
    auto findings = validators::policy_findings(policy, names, every_map_was_seen, today);
    if (findings.empty()) continue;
    reports.push_back({policy.path, policy.text, std::move(findings), {}});
  }
  return reports;
}

std::string policies_digest(const Policies& policies, validators::Date today) {
  std::string expired;
  std::vector<std::string_view> pieces;
  for (const auto& [path, policy] : policies) {
    pieces.push_back(path);
    pieces.push_back(policy.text);
    for (const auto& suppression : policy.suppressions) {
      expired += validators::has_expired(suppression, today) ? 'x' : '.';
    }
  }
  pieces.push_back(expired);
  return digest(pieces);
}

}  // namespace mapwright::cli
