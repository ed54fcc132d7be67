#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "mapcore/geometry/segment_index.hpp"
#include "validators/check.hpp"

namespace mapwright::validators {

struct CheckContext::Derived {
  explicit Derived(Survey made) : survey(std::move(made)) {}

  Survey survey;
  std::unordered_set<std::int64_t> incomplete;  // ids
  std::unordered_map<std::size_t, Outline> outlines;
  std::optional<std::vector<ObstaclePair>> near_pairs, meeting_pairs;
  std::optional<Nesting> nesting;
  std::unordered_map<std::size_t, EdgeFinder> edges;
};

namespace {

bool boxes_meet(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

std::vector<ObstaclePair> near_pairs_of(const std::vector<Box>& boxes, double reach_m) {
  std::vector<ObstaclePair> pairs;
  const auto add = [&](std::size_t i, std::size_t j) {
    pairs.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
  };
  for_each_meeting_pair(boxes, add, reach_m);
  std::sort(pairs.begin(), pairs.end(), [](const ObstaclePair& p, const ObstaclePair& q) {
    return std::tie(p.first, p.second) < std::tie(q.first, q.second);
  });
  return pairs;
}

bool loses_a_segment(FindingCode code) {
  switch (code) {
    case FindingCode::F108:
    case FindingCode::F109:
    case FindingCode::F110:
    case FindingCode::F116:
    case FindingCode::F118:
      return true;
    default:
      return false;
  }
}

}  // namespace

CheckContext::CheckContext(const MapDocument& document, const ValidationOptions& options,
                           Proofs proofs)
    : CheckContext(document, options, Survey(document.map, options, proofs)) {}

CheckContext::CheckContext(const MapDocument& document, const ValidationOptions& options,
                           Survey survey)
    : document_(document),
      options_(options),
      derived_(std::make_unique<Derived>(std::move(survey))) {
  for (const auto& finding : document.findings) {
    if (finding.obstacle && loses_a_segment(finding.code)) {
      derived_->incomplete.insert(*finding.obstacle);
    }
  }
}

CheckContext::~CheckContext() = default;

// The reader leaves a border that it cannot read at zero, and has said why.
bool CheckContext::border_was_read() const {
  return document_.findings.empty() || map().border != Border{};
}

bool CheckContext::has_usable_border() const {
  const Border& border = map().border;
  return border_was_read() && border.left < border.right && border.bottom < border.top;
}

bool CheckContext::is_complete(std::size_t obstacle) const {
  return derived_->incomplete.empty() ||
         derived_->incomplete.count(map().obstacles[obstacle].id) == 0;
}

const Survey& CheckContext::survey() const {
  return derived_->survey;
}

const Outline& CheckContext::outline(std::size_t obstacle) const {
  const auto found = derived_->outlines.find(obstacle);
  if (found != derived_->outlines.end()) return found->second;
  return derived_->outlines.emplace(obstacle, outline_of(map().obstacles[obstacle])).first->second;
}

const std::vector<ObstaclePair>& CheckContext::near_pairs() const {
  auto& pairs = derived_->near_pairs;
  if (!pairs) pairs = near_pairs_of(survey().boxes(), std::max(0.0, options_.near_miss_m));
  return *pairs;
}

const std::vector<ObstaclePair>& CheckContext::meeting_pairs() const {
  auto& pairs = derived_->meeting_pairs;
  if (!pairs) {
    pairs = near_pairs();
    std::erase_if(*pairs, [&](ObstaclePair p) { return !boxes_meet(box(p.first), box(p.second)); });
  }
  return *pairs;
}

const Nesting& CheckContext::nesting() const {
  if (!derived_->nesting) derived_->nesting.emplace(*this);
  return *derived_->nesting;
}

const EdgeFinder& CheckContext::edges(std::size_t obstacle) const {
  const auto found = derived_->edges.find(obstacle);
  if (found != derived_->edges.end()) return found->second;
  return derived_->edges.emplace(obstacle, EdgeFinder(map().obstacles[obstacle])).first->second;
}

}  // namespace mapwright::validators
