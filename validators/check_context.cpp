#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "mapcore/geometry/segment_index.hpp"
#include "validators/check.hpp"

namespace mapwright::validators {

struct CheckContext::Derived {
  std::unordered_set<std::int64_t> incomplete;  // ids
  std::optional<std::vector<Outline>> outlines;
  std::optional<std::vector<ObstaclePair>> pairs;
  std::optional<Nesting> nesting;
  std::unordered_map<std::size_t, EdgeFinder> edges;
};

namespace {

std::vector<ObstaclePair> pairs_of(const std::vector<Outline>& outlines) {
  std::vector<Box> boxes;
  boxes.reserve(outlines.size());
  for (const auto& outline : outlines) boxes.push_back(outline.box);
  std::vector<ObstaclePair> pairs;
  for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) {
    pairs.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
  });
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

CheckContext::CheckContext(const MapDocument& document, const ValidationOptions& options)
    : document_(document), options_(options), derived_(std::make_unique<Derived>()) {
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

const std::vector<Outline>& CheckContext::outlines() const {
  if (!derived_->outlines) {
    auto& outlines = derived_->outlines.emplace();
    outlines.reserve(map().obstacles.size());
    for (const auto& obstacle : map().obstacles) outlines.push_back(outline_of(obstacle));
  }
  return *derived_->outlines;
}

const std::vector<ObstaclePair>& CheckContext::meeting_pairs() const {
  if (!derived_->pairs) derived_->pairs = pairs_of(outlines());
  return *derived_->pairs;
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
