#include "converter/pipeline/tidy/simplification.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "converter/pipeline/tidy/draft_chain.hpp"
#include "mapcore/geometry/hausdorff.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright::converter {
namespace {

// Everything that is drawn, with the draft it belongs to.
SegmentIndex index_of(const std::vector<Draft>& drafts) {
  std::vector<IndexedSegment> segments;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    for (const auto& s : drafts[i].obstacle.segments) {
      segments.push_back({s.a, s.b, static_cast<std::uint32_t>(i)});
    }
  }
  return SegmentIndex(std::move(segments));
}

double distance_to(Point p, const DrawnEdge& edge) {
  return distance(p, closest_point_on_segment(p, edge.a, edge.b));
}

bool are_near(const DrawnEdge& p, const DrawnEdge& q, double reach_m) {
  return std::min({distance_to(p.a, q), distance_to(p.b, q), distance_to(q.a, p),
                   distance_to(q.b, p)}) <= reach_m ||
         meet(p.a, p.b, q.a, q.b).kind != Meeting::kNone;
}

class ChainSimplifier {
 public:
  ChainSimplifier(const SegmentIndex& everything, double tolerance_m)
      : everything_(everything), tolerance_m_(tolerance_m) {}

  DraftChain simplified(const DraftChain& chain, std::uint32_t draft) const {
    std::vector<Point> points = chain.points;
    if (chain.closed) points.push_back(points.front());
    const std::size_t last = points.size() - 1;
    std::vector<bool> kept(points.size(), false);
    kept[0] = kept[last] = true;
    for (std::size_t i = 1; i < last; ++i) kept[i] = has_company(points[i], draft);
    if (chain.closed) kept[farthest_from_start(points)] = true;
    for (std::size_t from = 0; from < last;) {
      std::size_t to = from + 1;
      while (!kept[to]) ++to;
      keep_corners(points, from, to, kept);
      keep_neighbourly(points, from, to, draft, kept);
      from = to;
    }
    return without_others(chain, points, kept);
  }

 private:
  bool has_company(Point p, std::uint32_t draft) const {
    const double reach_m = 2.0 * tolerance_m_;
    const Box around{p.x - reach_m, p.y - reach_m, p.x + reach_m, p.y + reach_m};
    return !everything_.query(around, [&](std::size_t i) {
      const auto& s = everything_[i];
      return s.tag == draft || distance_to(p, {s.a, s.b}) > reach_m;
    });
  }

  // Whether somebody else stands where an edge is to run, or nearly.
  bool has_company(const DrawnEdge& edge, std::uint32_t draft) const {
    const double reach_m = 2.0 * tolerance_m_;
    Box around = kEmptyBox;
    around.add(edge.a);
    around.add(edge.b);
    return !everything_.query(around.inflated(reach_m), [&](std::size_t i) {
      const auto& s = everything_[i];
      return s.tag == draft || !are_near(edge, {s.a, s.b}, reach_m);
    });
  }

  static std::size_t farthest_from_start(const std::vector<Point>& points) {
    std::size_t farthest = 1;
    for (std::size_t i = 2; i + 1 < points.size(); ++i) {
      if (distance(points[i], points[0]) > distance(points[farthest], points[0])) farthest = i;
    }
    return farthest;
  }

  // Without recursion: chains may have a million vertices.
  void keep_corners(const std::vector<Point>& points, std::size_t first, std::size_t end,
                    std::vector<bool>& kept) const {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, end}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      std::size_t corner = from;
      double farthest_m = tolerance_m_;
      for (std::size_t i = from + 1; i < to; ++i) {
        const double away_m = distance_to(points[i], {points[from], points[to]});
        if (away_m <= farthest_m) continue;
        farthest_m = away_m;
        corner = i;
      }
      if (corner == from) continue;
      kept[corner] = true;
      open.push_back({from, corner});
      open.push_back({corner, to});
    }
  }

  // What was drawn stays where a shortcut would come near to somebody else.
  void keep_neighbourly(const std::vector<Point>& points, std::size_t first, std::size_t end,
                        std::uint32_t draft, std::vector<bool>& kept) const {
    for (std::size_t from = first; from < end;) {
      std::size_t to = from + 1;
      while (!kept[to]) ++to;
      if (to > from + 1 && has_company(DrawnEdge{points[from], points[to]}, draft)) {
        for (std::size_t i = from + 1; i < to; ++i) kept[i] = true;
      }
      from = to;
    }
  }

  static DraftChain without_others(const DraftChain& chain, const std::vector<Point>& points,
                                   const std::vector<bool>& kept) {
    DraftChain result = chain;
    result.points.clear();
    const std::size_t count = points.size() - (chain.closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      if (kept[i]) result.points.push_back(points[i]);
    }
    return result;
  }

  const SegmentIndex& everything_;
  double tolerance_m_;
};

void tell(const Draft& draft, const DraftChain& before, const DraftChain& after, Ledger& ledger) {
  const double moved_m = hausdorff_distance_m(edges_of(before.points, before.closed),
                                              edges_of(after.points, after.closed), 1e-4);
  std::optional<double> area;
  if (before.closed)
    area = std::abs(signed_area_m2(after.points)) - std::abs(signed_area_m2(before.points));
  for (const std::size_t account : draft.features) {
    ledger.change(account, FindingCode::C251,
                  std::to_string(before.points.size()) + " vertices became " +
                      std::to_string(after.points.size()),
                  {moved_m, area});
  }
}

}  // namespace

void simplify_drafts(Workspace& workspace, double tolerance_m) {
  const SegmentIndex everything = index_of(workspace.drafts);
  const ChainSimplifier simplifier(everything, tolerance_m);
  for (std::size_t i = 0; i < workspace.drafts.size(); ++i) {
    auto& draft = workspace.drafts[i];
    const auto chain = chain_of_draft(draft);
    if (!chain || chain->points.size() < 3) continue;
    const auto tag = static_cast<std::uint32_t>(i);
    const DraftChain fewer = simplifier.simplified(*chain, tag);
    const bool shrank = fewer.points.size() < chain->points.size();
    if (!shrank || !is_sound(fewer)) continue;
    tell(draft, *chain, fewer, workspace.ledger);
    set_chain(fewer, draft);
  }
}

}  // namespace mapwright::converter
