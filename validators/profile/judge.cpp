#include "validators/profile/judge.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace mapwright::validators {
namespace {

std::vector<Finding> with_severities(std::vector<Finding> findings, const Profile& profile) {
  std::vector<Finding> kept;
  kept.reserve(findings.size());
  for (auto& finding : findings) {
    const auto severity = severity_in(profile, finding);
    if (!severity) continue;
    finding.severity = *severity;
    kept.push_back(std::move(finding));
  }
  return kept;
}

const Suppression* suppression_of(const JudgeContext& context, const Candidate& candidate) {
  const auto& all = context.policy.suppressions;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Suppression& suppression) {
    return !has_expired(suppression, context.today) && covers(suppression, candidate);
  });
  return found == all.end() ? nullptr : &*found;
}

// Moves the findings for which `why` knows a suppression out of the judgement.
template <class Why>
void set_aside(Judgement& judgement, const Why& why) {
  Judgement kept;
  kept.suppressed = std::move(judgement.suppressed);
  for (std::size_t i = 0; i < judgement.findings.size(); ++i) {
    auto& finding = judgement.findings[i];
    auto& name = judgement.names[i];
    if (std::optional<std::pair<std::string, std::string>> reason = why(i)) {
      kept.suppressed.push_back(
          {std::move(finding), std::move(name), reason->first, reason->second});
    } else {
      kept.findings.push_back(std::move(finding));
      kept.names.push_back(std::move(name));
    }
  }
  judgement = std::move(kept);
}

void apply_suppressions(Judgement& judgement, const JudgeContext& context) {
  set_aside(judgement, [&](std::size_t i) -> std::optional<std::pair<std::string, std::string>> {
    const auto* suppression =
        suppression_of(context, {judgement.findings[i], judgement.names[i], context.path});
    if (suppression == nullptr) return std::nullopt;
    return std::pair(suppression_name(context.policy, *suppression), suppression->reason);
  });
}

void apply_baseline(Judgement& judgement, const JudgeContext& context) {
  const auto is_known = known_among(*context.known, judgement.findings, judgement.names);
  set_aside(judgement, [&](std::size_t i) -> std::optional<std::pair<std::string, std::string>> {
    if (!is_known[i]) return std::nullopt;
    return std::pair(std::string(context.baseline_path), std::string("known since the baseline"));
  });
}

Finding finding_about(FindingCode code, const Suppression& suppression, std::string message) {
  Finding finding = make_finding(code, std::move(message));
  finding.place = suppression.place;
  return finding;
}

std::string codes_text(const Suppression& suppression) {
  std::string text;
  for (const auto code : suppression.codes) {
    text += (text.empty() ? "" : ", ") + std::string(finding_type(code).id);
  }
  return text;
}

}  // namespace

Judgement judge(std::vector<Finding> findings, const JudgeContext& context) {
  Judgement judgement;
  judgement.findings = with_severities(std::move(findings), context.policy.profile);
  judgement.names = fingerprints(context.document, judgement.findings);
  if (!context.policy.suppressions.empty()) apply_suppressions(judgement, context);
  if (context.known != nullptr) apply_baseline(judgement, context);
  return judgement;
}

std::string suppression_name(const Policy& policy, const Suppression& suppression) {
  return policy.path + ":" + std::to_string(suppression.place.line) + ":" +
         std::to_string(suppression.place.column);
}

std::vector<Finding> policy_findings(const Policy& policy, const std::vector<std::string>& used,
                                     bool every_map_was_seen, Date today) {
  const std::set<std::string> used_names(used.begin(), used.end());
  std::vector<Finding> findings;
  for (const auto& suppression : policy.suppressions) {
    const std::string subject = "the suppression of " + codes_text(suppression);
    if (has_expired(suppression, today)) {
      findings.push_back(finding_about(FindingCode::C302, suppression,
                                       subject + " held until " + date_text(*suppression.until) +
                                           "; look again at what it covers, then remove it or "
                                           "give it another day"));
    } else if (every_map_was_seen && used_names.count(suppression_name(policy, suppression)) == 0) {
      findings.push_back(finding_about(
          FindingCode::C301, suppression,
          subject + " covers nothing that was found; remove it, or correct what it names"));
    }
  }
  return with_severities(std::move(findings), policy.profile);
}

}  // namespace mapwright::validators
