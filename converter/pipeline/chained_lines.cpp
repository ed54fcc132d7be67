#include "converter/pipeline/chained_lines.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

// Each join looks at the whole chain again.
constexpr std::size_t kMostSegments = 1000;

struct PointOrder {
  bool operator()(Point p, Point q) const { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }
};

// What lines must share to be one wall.
using Likeness = std::tuple<std::size_t, ShapeType, double, int, std::string, std::string>;

Likeness likeness_of(const Draft& draft) {
  const auto& first = draft.obstacle.segments.front();
  return {draft.source,
          draft.obstacle.shape_type,
          first.height_m,
          static_cast<int>(first.in_out),
          std::string(draft.obstacle.semantic.view()),
          std::string(first.semantic.view())};
}

Point start_of(const Draft& draft) {
  return draft.obstacle.segments.front().a;
}
Point end_of(const Draft& draft) {
  return draft.obstacle.segments.back().b;
}

void turn(Draft& draft) {
  auto& segments = draft.obstacle.segments;
  std::reverse(segments.begin(), segments.end());
  for (auto& segment : segments) std::swap(segment.a, segment.b);
}

bool stays_simple(const Draft& draft) {
  std::vector<Point> points{start_of(draft)};
  for (const auto& segment : draft.obstacle.segments) points.push_back(segment.b);
  const bool closed = points.front() == points.back() && points.size() > 3;
  if (!closed) return is_simple_chain(points);
  points.pop_back();
  return is_simple_ring(points);
}

// The lines of one likeness and the ends that meet.
class Chainer {
 public:
  Chainer(std::vector<Draft>& drafts, const std::vector<std::size_t>& members) : drafts_(drafts) {
    for (const auto i : members) {
      meeting_[start_of(drafts[i])].push_back(i);
      meeting_[end_of(drafts[i])].push_back(i);
    }
  }

  // Grows the chain of a draft at its end as long as exactly one other line goes on there.
  void grow(std::size_t chain, std::vector<bool>& taken) {
    while (start_of(drafts_[chain]) != end_of(drafts_[chain])) {
      const auto& there = meeting_[end_of(drafts_[chain])];
      if (there.size() != 2) return;
      const auto next = taken[there[0]] || there[0] == chain ? there[1] : there[0];
      if (taken[next] || next == chain || !append(chain, next)) return;
      taken[next] = true;
    }
  }

 private:
  bool append(std::size_t chain, std::size_t next) {
    Draft& joined = drafts_[chain];
    Draft& piece = drafts_[next];
    auto& segments = joined.obstacle.segments;
    const std::size_t before = segments.size();
    if (before >= kMostSegments) return false;
    if (start_of(piece) != end_of(joined)) turn(piece);
    segments.insert(segments.end(), piece.obstacle.segments.begin(), piece.obstacle.segments.end());
    if (!stays_simple(joined)) {
      segments.resize(before);
      return false;
    }
    // A feature may have several lines.
    auto& features = joined.features;
    for (const auto account : piece.features) {
      const bool is_known = std::find(features.begin(), features.end(), account) != features.end();
      if (!is_known) features.push_back(account);
    }
    return true;
  }

  std::vector<Draft>& drafts_;
  std::map<Point, std::vector<std::size_t>, PointOrder> meeting_;
};

bool is_loose_line(const Draft& draft) {
  const auto type = draft.obstacle.shape_type;
  return draft.kind == FeatureKind::kWall && !draft.inner_of && !draft.obstacle.segments.empty() &&
         (type == ShapeType::kOpenPolygon || type == ShapeType::kOpenCurve) &&
         start_of(draft) != end_of(draft);
}

void tell(const Draft& chain, Ledger& ledger) {
  for (const auto account : chain.features) {
    ledger.remark(account, FindingCode::C230,
                  "joined end to end with " + std::to_string(chain.features.size() - 1) +
                      " other lines into one wall");
  }
}

// Takes joined drafts out; positions that inner rings refer to follow.
void remove(const std::vector<bool>& taken, std::vector<Draft>& drafts) {
  std::vector<std::size_t> moved(drafts.size());
  std::vector<Draft> kept;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    moved[i] = kept.size();
    if (!taken[i]) kept.push_back(std::move(drafts[i]));
  }
  for (auto& draft : kept) {
    if (draft.inner_of) draft.inner_of = moved[*draft.inner_of];
  }
  drafts = std::move(kept);
}

}  // namespace

void chain_lines(const std::vector<bool>& joins, Workspace& workspace) {
  auto& drafts = workspace.drafts;
  std::map<Likeness, std::vector<std::size_t>> alike;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (joins[drafts[i].source] && is_loose_line(drafts[i])) {
      alike[likeness_of(drafts[i])].push_back(i);
    }
  }
  std::vector<bool> taken(drafts.size(), false);
  for (const auto& [likeness, members] : alike) {
    Chainer chainer(drafts, members);
    for (const auto i : members) {
      if (taken[i]) continue;
      const std::size_t parts = drafts[i].features.size();
      chainer.grow(i, taken);
      turn(drafts[i]);
      chainer.grow(i, taken);
      turn(drafts[i]);
      if (drafts[i].features.size() > parts) tell(drafts[i], workspace.ledger);
    }
  }
  remove(taken, drafts);
}

}  // namespace mapwright::converter
