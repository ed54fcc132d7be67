#include "converter/pipeline/tidy/snapping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "converter/pipeline/tidy/draft_chain.hpp"

namespace mapwright::converter {
namespace {

// Points that others may be moved to, by cells as wide as the tolerance.
class Anchors {
 public:
  explicit Anchors(double tolerance_m) : tolerance_m_(tolerance_m) {}

  // The nearest anchor within the tolerance, of equally near ones the first; p itself where there
  // is none.
  Point near(Point p) const {
    Point best = p;
    double best_m = tolerance_m_;
    bool found = false;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto cell = cells_.find(key(column(p.x) + dx, column(p.y) + dy));
        if (cell == cells_.end()) continue;
        for (const Point anchor : cell->second) {
          const double away_m = distance(p, anchor);
          if (away_m > tolerance_m_ || (found && away_m >= best_m)) continue;
          best = anchor;
          best_m = away_m;
          found = true;
        }
      }
    }
    return best;
  }

  void add(Point p) { cells_[key(column(p.x), column(p.y))].push_back(p); }

 private:
  std::int64_t column(double value) const {
    return static_cast<std::int64_t>(std::floor(value / tolerance_m_));
  }
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL ^
           static_cast<std::uint64_t>(row);
  }

  double tolerance_m_;
  std::unordered_map<std::uint64_t, std::vector<Point>> cells_;
};

void drop_repeats(DraftChain& chain) {
  auto& points = chain.points;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (chain.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
}

// The chain with its vertices at anchors; the greatest move.
double snap(DraftChain& chain, const Anchors& anchors) {
  double farthest_m = 0.0;
  for (Point& p : chain.points) {
    const Point anchor = anchors.near(p);
    farthest_m = std::max(farthest_m, distance(p, anchor));
    p = anchor;
  }
  if (farthest_m > 0.0) drop_repeats(chain);
  return farthest_m;
}

}  // namespace

void snap_vertices(Workspace& workspace, double tolerance_m) {
  Anchors anchors(tolerance_m);
  for (auto& draft : workspace.drafts) {
    const auto chain = chain_of_draft(draft);
    if (chain) {
      DraftChain moved = *chain;
      const double farthest_m = snap(moved, anchors);
      if (farthest_m > 0.0 && is_sound(moved)) {
        set_chain(moved, draft);
        for (const std::size_t account : draft.features) {
          workspace.ledger.change(account, FindingCode::C250,
                                  "vertices were moved to those of others nearby",
                                  {farthest_m, std::nullopt});
        }
      }
    }
    for (const Point p : chain_points(draft.obstacle)) {
      if (anchors.near(p) == p) anchors.add(p);
    }
  }
}

}  // namespace mapwright::converter
