#include "validators/fix/fix_map.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "mapcore/text/reader.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

constexpr std::array kFixers{
#define MAPWRIGHT_FIX(name, codes, summary) &fix_##name,
#include "validators/fix/fixes.def"
#undef MAPWRIGHT_FIX
};

constexpr std::array kFixedCodes{
#define MAPWRIGHT_FIX(name, codes, summary) std::string_view(codes),
#include "validators/fix/fixes.def"
#undef MAPWRIGHT_FIX
};

// More rounds than repairs can need to prepare each other's ground.
constexpr std::size_t kMostRounds = 8;
constexpr std::size_t kMostAttempts = 64;

/// Names a repair while others are tried without it: code and position of the obstacle.
using RepairKey = std::pair<std::optional<FindingCode>, std::optional<std::size_t>>;

struct Step {
  RepairKey key;
  Repair repair;
};

/// A map after repairs.
struct Attempt {
  std::string text;
  std::vector<Step> steps;
  std::vector<Finding> findings;
  bool is_settled = false;  ///< nothing is left to repair
};

// What a finding is about: a repair may change its line, its segment's number and its words.
using Complaint = std::tuple<FindingCode, std::optional<std::int64_t>>;

Complaint complaint(const Finding& finding) {
  return {finding.code, finding.obstacle};
}

std::vector<Finding> not_among(const std::vector<Finding>& after,
                               const std::vector<Finding>& before) {
  std::map<Complaint, std::size_t> known;
  for (const auto& finding : before) ++known[complaint(finding)];
  std::vector<Finding> fresh;
  for (const auto& finding : after) {
    auto& left = known[complaint(finding)];
    if (left > 0) {
      --left;
    } else {
      fresh.push_back(finding);
    }
  }
  return fresh;
}

/// Proposals whose edits do not meet those of an earlier one, with all edits in order.
class Batch {
 public:
  bool add(const Proposal& proposal) {
    for (const auto& edit : proposal.edits) {
      if (meets_another(edit)) return false;
    }
    for (const auto& edit : proposal.edits) edits_.emplace(edit.begin, edit);
    return true;
  }

  std::string applied_to(std::string_view text) const {
    std::vector<OffsetEdit> edits;
    for (const auto& [begin, edit] : edits_) edits.push_back(edit);
    return edited(text, edits);
  }

 private:
  bool meets_another(const OffsetEdit& edit) const {
    const auto next = edits_.lower_bound(edit.begin);
    if (next != edits_.end() && (next->first < edit.end || next->first == edit.begin)) return true;
    return next != edits_.begin() && std::prev(next)->second.end > edit.begin;
  }

  std::multimap<std::size_t, OffsetEdit> edits_;
};

/// Runs all fixers, but for some repairs.
class Runner {
 public:
  Runner(const std::string& text, const FixOptions& options, const std::set<RepairKey>& banned)
      : options_(options), banned_(banned), document_(read_map(text)) {
    attempt_.findings = validate(document_, options_.validation);
  }

  Attempt run() {
    for (std::size_t round = 0; round < kMostRounds && !attempt_.is_settled; ++round) {
      attempt_.is_settled = true;
      for (const auto fixer : kFixers) {
        if (run_fixer(*fixer)) attempt_.is_settled = false;
      }
    }
    attempt_.text = document_.text.str();
    return std::move(attempt_);
  }

 private:
  bool is_wanted(const Proposal& proposal) const {
    if (banned_.count({proposal.code, proposal.obstacle}) > 0) return false;
    return proposal.code ? options_.codes.count(*proposal.code) > 0 : options_.layout;
  }

  bool run_fixer(Fixer& fixer) {
    Batch batch;
    bool changed = false;
    for (auto& proposal : fixer({document_, attempt_.findings, options_.snap_m})) {
      if (proposal.edits.empty() || !is_wanted(proposal) || !batch.add(proposal)) continue;
      take_note(std::move(proposal));
      changed = true;
    }
    if (!changed) return false;
    document_ = read_map(batch.applied_to(document_.text));
    attempt_.findings = validate(document_, options_.validation);
    return true;
  }

  void take_note(Proposal proposal) {
    Step step{{proposal.code, proposal.obstacle},
              {proposal.code, {}, std::move(proposal.message), proposal.moved_m}};
    if (proposal.obstacle) step.repair.obstacle = document_.map.obstacles[*proposal.obstacle].id;
    attempt_.steps.push_back(std::move(step));
  }

  const FixOptions& options_;
  const std::set<RepairKey>& banned_;
  MapDocument document_;
  Attempt attempt_;
};

/// Leaves repairs out until none brings a finding.
class Search {
 public:
  Search(const std::string& text, const FixOptions& options) : text_(text), options_(options) {}

  Attempt best() {
    const auto before = validate(read_map(text_), options_.validation);
    for (std::size_t count = 0; count < kMostAttempts; ++count) {
      Attempt attempt = Runner(text_, options_, banned_).run();
      auto fresh = not_among(attempt.findings, before);
      if (fresh.empty() && attempt.is_settled) return attempt;
      leave_out(attempt, fresh);
    }
    FixOptions nothing = options_;
    nothing.codes.clear();
    nothing.layout = false;
    return Runner(text_, nothing, banned_).run();
  }

  std::vector<Repair> take_undone() { return std::move(undone_); }

 private:
  // The last repair of each obstacle that a new finding is about; where there is none, and where
  // repairs undo each other for ever, the last one of all.
  void leave_out(const Attempt& attempt, const std::vector<Finding>& fresh) {
    const std::size_t left_out_before = banned_.size();
    for (const auto& finding : fresh) {
      const auto of_it =
          std::find_if(attempt.steps.rbegin(), attempt.steps.rend(), [&](const Step& step) {
            return step.repair.obstacle && step.repair.obstacle == finding.obstacle;
          });
      if (of_it != attempt.steps.rend()) leave_out(*of_it, {finding});
    }
    if (banned_.size() == left_out_before) leave_out(last_but_layout(attempt), fresh);
  }

  static const Step& last_but_layout(const Attempt& attempt) {
    const auto last = std::find_if(attempt.steps.rbegin(), attempt.steps.rend(),
                                   [](const Step& step) { return step.repair.code.has_value(); });
    return last != attempt.steps.rend() ? *last : attempt.steps.back();
  }

  void leave_out(const Step& step, std::vector<Finding> brought) {
    if (!banned_.insert(step.key).second) return;
    undone_.push_back(step.repair);
    undone_.back().brought = std::move(brought);
  }

  const std::string& text_;
  const FixOptions& options_;
  std::set<RepairKey> banned_;
  std::vector<Repair> undone_;
};

void add_movements(FixOutcome& outcome) {
  std::map<std::int64_t, double> moved;
  for (const auto& repair : outcome.done) {
    if (repair.moved_m == 0.0) continue;
    double& most = repair.obstacle ? moved[*repair.obstacle] : outcome.border_moved_m;
    most = std::max(most, repair.moved_m);
  }
  for (const auto& [id, moved_m] : moved) outcome.moved.push_back({id, moved_m});
}

}  // namespace

const std::vector<FindingCode>& fixable_codes() {
  static const std::vector<FindingCode> all = [] {
    std::vector<FindingCode> codes;
    for (std::string_view words : kFixedCodes) {
      while (!words.empty()) {
        if (const auto code = finding_code(words.substr(0, words.find(' '))))
          codes.push_back(*code);
        words.remove_prefix(std::min(words.size(), words.substr(0, words.find(' ')).size() + 1));
      }
    }
    std::sort(codes.begin(), codes.end());
    return codes;
  }();
  return all;
}

// A repair that was left out because of another may do no harm once that one is done: what comes
// out is repaired again until nothing changes.
FixOutcome fix_map(std::string text, const FixOptions& options) {
  FixOutcome outcome;
  outcome.before = validate(read_map(text), options.validation);
  outcome.text = std::move(text);
  for (std::size_t round = 0; round < kMostRounds; ++round) {
    Search search(outcome.text, options);
    Attempt attempt = search.best();
    outcome.undone = search.take_undone();
    outcome.after = std::move(attempt.findings);
    for (auto& step : attempt.steps) outcome.done.push_back(std::move(step.repair));
    if (attempt.text == outcome.text) break;
    outcome.text = std::move(attempt.text);
  }
  add_movements(outcome);
  return outcome;
}

}  // namespace mapwright::validators
