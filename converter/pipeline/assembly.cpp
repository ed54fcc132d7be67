#include "converter/pipeline/assembly.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace mapwright::converter {
namespace {

using Ends = std::tuple<double, double, double, double>;

// The same for both directions.
Ends ends_of(const Segment& segment) {
  const auto a = std::pair(segment.a.x, segment.a.y);
  const auto b = std::pair(segment.b.x, segment.b.y);
  const auto& [p, q] = std::minmax(a, b);
  return {p.first, p.second, q.first, q.second};
}

std::set<Ends> step_ends(const std::vector<Draft>& drafts) {
  std::set<Ends> ends;
  for (const auto& draft : drafts) {
    if (draft.obstacle.shape_type != ShapeType::kStairs) continue;
    for (const auto& segment : draft.obstacle.segments) {
      if (segment.height_m > 0.0) ends.insert(ends_of(segment));
    }
  }
  return ends;
}

bool is_open_wall(const Draft& draft) {
  return draft.kind == FeatureKind::kWall && is_open_chain(draft.obstacle.shape_type);
}

// A wall that was taken for stairs; exported obstacles stay as they are, also empty ones.
bool is_gone(const Draft& draft) {
  return draft.kind != FeatureKind::kObstacle && draft.obstacle.segments.empty();
}

// Exported obstacles in the order of their map, then what was drawn anew.
bool comes_before(const Recorded& p, const Recorded& q) {
  return std::tie(p.place, p.position) < std::tie(q.place, q.position);
}

// Positions of the drafts in the order of the map.
std::vector<std::size_t> map_order(const Workspace& workspace) {
  std::vector<std::size_t> order(workspace.drafts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::string> keys;
  for (const auto& source : workspace.ledger.sources) keys.push_back(source.layer);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const Draft& p = workspace.drafts[i];
    const Draft& q = workspace.drafts[j];
    if (p.recorded && q.recorded) return comes_before(*p.recorded, *q.recorded);
    if (p.recorded || q.recorded) return p.recorded.has_value();
    if (p.kind != q.kind) return p.kind < q.kind;
    return p.source != q.source && keys[p.source] < keys[q.source];
  });
  return order;
}

// Exported obstacles keep their ids unless another source has them; new ones get those behind.
class Ids {
 public:
  explicit Ids(const std::vector<Draft>& drafts) {
    for (const auto& draft : drafts) {
      if (!draft.recorded) continue;
      places_.try_emplace(draft.recorded->id, draft.recorded->place);
      last_ = std::max(last_, draft.recorded->id);
    }
    if (last_ == std::numeric_limits<std::int64_t>::max()) last_ = 0;
  }

  std::int64_t of(const Draft& draft) {
    if (draft.recorded && places_.at(draft.recorded->id) == draft.recorded->place) {
      return draft.recorded->id;
    }
    do ++last_;
    while (places_.count(last_) > 0);
    return last_;
  }

 private:
  std::map<std::int64_t, std::size_t> places_;  // which export each id belongs to
  std::int64_t last_ = 0;
};

void number_drafts(Workspace& workspace, const std::vector<std::size_t>& order) {
  Ids ids(workspace.drafts);
  for (const std::size_t i : order) {
    auto& draft = workspace.drafts[i];
    draft.obstacle.id = ids.of(draft);
    const bool renumbered = draft.recorded && draft.recorded->id != draft.obstacle.id;
    for (const std::size_t account : draft.features) {
      if (!renumbered) break;
      workspace.ledger.change(account, FindingCode::C260,
                              "id " + std::to_string(draft.recorded->id) +
                                  " is taken by another source: now " +
                                  std::to_string(draft.obstacle.id));
    }
  }
  for (auto& draft : workspace.drafts) {
    if (draft.inner_of) {
      const auto outer = std::to_string(workspace.drafts[*draft.inner_of].obstacle.id);
      auto& semantic = draft.obstacle.semantic;
      if (semantic.value(semantic_key::kInnerOf) != outer) {
        semantic = semantic.with_value(semantic_key::kInnerOf, outer);
      }
    }
    for (const std::size_t account : draft.features) {
      workspace.ledger.features[account].obstacles.push_back(draft.obstacle.id);
    }
  }
}

bool is_remark(const LedgerReason& reason) {
  return reason.code == FindingCode::C227;
}

// What began as written or changed but left nothing behind is lost, for the reasons given.
void close_accounts(Ledger& ledger) {
  for (auto& feature : ledger.features) {
    std::sort(feature.obstacles.begin(), feature.obstacles.end());
    const bool drew_border = std::any_of(feature.reasons.begin(), feature.reasons.end(), is_remark);
    if (feature.obstacles.empty() && !drew_border) feature.outcome = Outcome::kDropped;
  }
}

Border border_of(const Map& map, const Workspace& workspace) {
  const auto round = [&](double value) { return workspace.resolution.rounded(value); };
  if (workspace.exported_border) return *workspace.exported_border;
  Box box = workspace.border;
  if (box.is_empty()) box = extent(map).inflated(workspace.settings.border_margin_m);
  return {round(box.min_x), round(box.max_y), round(box.max_x), round(box.min_y)};
}

}  // namespace

void drop_walls_that_are_steps(Workspace& workspace) {
  const auto steps = step_ends(workspace.drafts);
  if (steps.empty()) return;
  for (auto& draft : workspace.drafts) {
    auto& segments = draft.obstacle.segments;
    if (!is_open_wall(draft) || segments.empty()) continue;
    const bool all = std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
      return steps.count(ends_of(segment)) > 0;
    });
    if (!all) continue;
    segments.clear();
    for (const std::size_t account : draft.features) {
      workspace.ledger.change(account, FindingCode::C212, "the line is a step of stairs as well");
    }
  }
  // Open walls are nobody's outer ring, so no position that others remember goes away with them.
  std::vector<std::size_t> moved(workspace.drafts.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = kept;
    if (!is_gone(workspace.drafts[i])) ++kept;
  }
  for (auto& draft : workspace.drafts) {
    if (draft.inner_of) draft.inner_of = moved[*draft.inner_of];
  }
  std::erase_if(workspace.drafts, is_gone);
}

Map assemble(Workspace& workspace) {
  const auto order = map_order(workspace);
  number_drafts(workspace, order);
  close_accounts(workspace.ledger);
  Map map;
  map.obstacles.reserve(order.size());
  for (const std::size_t i : order)
    map.obstacles.push_back(std::move(workspace.drafts[i].obstacle));
  workspace.drafts.clear();
  if (!map.obstacles.empty()) map.border = border_of(map, workspace);
  return map;
}

}  // namespace mapwright::converter
