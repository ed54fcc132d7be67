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
Ends ends_of(Point from, Point to) {
  const auto a = std::pair(from.x, from.y);
  const auto b = std::pair(to.x, to.y);
  const auto& [p, q] = std::minmax(a, b);
  return {p.first, p.second, q.first, q.second};
}

Ends ends_of(const Segment& segment) {
  return ends_of(segment.a, segment.b);
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

std::vector<std::string> layer_names(const Ledger& ledger) {
  std::vector<std::string> names;
  for (const auto& source : ledger.sources) names.push_back(source.layer);
  return names;
}

// Positions of the drafts in the order of the map.
std::vector<std::size_t> map_order(const Workspace& workspace) {
  std::vector<std::size_t> order(workspace.drafts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto keys = layer_names(workspace.ledger);
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
    return next();
  }

  // The next one that nobody has.
  std::int64_t next() {
    do ++last_;
    while (!places_.empty() && places_.count(last_) > 0);
    return last_;
  }

 private:
  std::map<std::int64_t, std::size_t> places_;  // which export each id belongs to
  std::int64_t last_ = 0;
};

// Runs of plain obstacles in the order of the map.
std::vector<PlainRun> plain_order(const Workspace& workspace) {
  auto runs = workspace.plain.runs();
  const auto keys = layer_names(workspace.ledger);
  std::stable_sort(runs.begin(), runs.end(), [&](const PlainRun& p, const PlainRun& q) {
    if (p.kind != q.kind) return p.kind < q.kind;
    return p.source != q.source && keys[p.source] < keys[q.source];
  });
  return runs;
}

// Drafts and plain obstacles, each in their order, as one. No layer has both of one kind.
std::vector<ConvertedMap::Run> merged_order(const Workspace& workspace,
                                            const std::vector<std::size_t>& order) {
  const auto keys = layer_names(workspace.ledger);
  const auto comes_first = [&](const Draft& draft, const PlainRun& run) {
    if (draft.recorded) return true;
    return std::tie(draft.kind, keys[draft.source], draft.source) <
           std::tie(run.kind, keys[run.source], run.source);
  };
  std::vector<ConvertedMap::Run> merged;
  std::size_t next = 0;
  const auto append_drafts = [&](std::size_t end) {
    if (end > next) merged.push_back({false, next, end});
    next = end;
  };
  for (const auto& run : plain_order(workspace)) {
    std::size_t end = next;
    while (end < order.size() && comes_first(workspace.drafts[order[end]], run)) ++end;
    append_drafts(end);
    merged.push_back({true, run.first, run.end});
  }
  append_drafts(order.size());
  return merged;
}

void number(Draft& draft, Ids& ids, Ledger& ledger) {
  draft.obstacle.id = ids.of(draft);
  if (!draft.recorded || draft.recorded->id == draft.obstacle.id) return;
  for (const std::size_t account : draft.features) {
    ledger.change(account, FindingCode::C260,
                  "id " + std::to_string(draft.recorded->id) + " is taken by another source: now " +
                      std::to_string(draft.obstacle.id));
  }
}

// Plain obstacles tell the ledger at once: there are too many to come back to.
void number_all(Workspace& workspace, const std::vector<std::size_t>& order,
                const std::vector<ConvertedMap::Run>& merged) {
  Ids ids(workspace.drafts);
  for (const auto& run : merged) {
    for (std::size_t i = run.first; i < run.end; ++i) {
      if (!run.plain) {
        number(workspace.drafts[order[i]], ids, workspace.ledger);
        continue;
      }
      auto& plain = workspace.plain.all()[i];
      plain.id = ids.next();
      workspace.ledger.features[plain.account].obstacles.push_back(plain.id);
    }
  }
}

// Tells holes, and the ledger of drafts, which ids were given.
void hand_out_ids(Workspace& workspace) {
  for (auto& draft : workspace.drafts) {
    if (draft.inner_of) {
      const auto outer = workspace.drafts[*draft.inner_of].obstacle.id;
      draft.obstacle.semantic = tied_to(outer, draft.obstacle.semantic);
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
    feature.obstacles.sort();
    const bool drew_border = std::any_of(feature.reasons.begin(), feature.reasons.end(), is_remark);
    if (feature.obstacles.empty() && !drew_border) feature.outcome = Outcome::kDropped;
  }
}

Border border_of(const ConvertedMap& map, const Workspace& workspace) {
  const auto round = [&](double value) { return workspace.resolution.rounded(value); };
  if (workspace.exported_border) return *workspace.exported_border;
  Box box = workspace.border;
  if (box.is_empty()) box = map.extent().inflated(workspace.settings.border_margin_m);
  return {round(box.min_x), round(box.max_y), round(box.max_x), round(box.min_y)};
}

bool are_steps(const PlainObstacle& wall, std::span<const Point> chain,
               const std::set<Ends>& steps) {
  for (std::size_t i = 0; i < wall.segment_count(); ++i) {
    if (steps.count(ends_of(chain[i], chain[i + 1 == chain.size() ? 0 : i + 1])) == 0) return false;
  }
  return true;
}

void say_step(std::size_t account, Ledger& ledger) {
  ledger.change(account, FindingCode::C212, "the line is a step of stairs as well");
}

void drop_plain_walls(const std::set<Ends>& steps, Workspace& workspace) {
  bool some = false;
  std::vector<Point> room;
  for (const auto& run : workspace.plain.runs()) {
    if (run.kind != FeatureKind::kWall) continue;
    for (std::size_t i = run.first; i < run.end; ++i) {
      auto& wall = workspace.plain.all()[i];
      wall.is_gone = is_open_chain(wall.shape_type) &&
                     are_steps(wall, workspace.plain.chain(wall, room), steps);
      some = some || wall.is_gone;
      if (wall.is_gone) say_step(wall.account, workspace.ledger);
    }
  }
  if (some) workspace.plain.remove_gone();
}

}  // namespace

void drop_walls_that_are_steps(Workspace& workspace) {
  const auto steps = step_ends(workspace.drafts);
  if (steps.empty()) return;
  drop_plain_walls(steps, workspace);
  for (auto& draft : workspace.drafts) {
    auto& segments = draft.obstacle.segments;
    if (!is_open_wall(draft) || segments.empty()) continue;
    const bool all = std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
      return steps.count(ends_of(segment)) > 0;
    });
    if (!all) continue;
    segments.clear();
    for (const std::size_t account : draft.features) say_step(account, workspace.ledger);
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

ConvertedMap assemble(Workspace& workspace) {
  const auto order = map_order(workspace);
  auto merged = merged_order(workspace, order);
  number_all(workspace, order, merged);
  hand_out_ids(workspace);
  close_accounts(workspace.ledger);
  std::vector<Obstacle> others;
  others.reserve(order.size());
  for (const std::size_t i : order) others.push_back(std::move(workspace.drafts[i].obstacle));
  workspace.drafts.clear();
  ConvertedMap map(std::move(workspace.plain), std::move(others), std::move(merged));
  if (!map.is_empty()) map.border = border_of(map, workspace);
  return map;
}

}  // namespace mapwright::converter
