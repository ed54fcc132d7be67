#include "converter/pipeline/tidy/dissolving.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "converter/pipeline/tidy/draft_chain.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/ring_union.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright::converter {
namespace {

// An outline with its holes, by their positions among the drafts.
struct Solid {
  std::size_t outer = 0;
  std::vector<std::size_t> holes;
  DraftChain chain;  // of the outline
};

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // The earlier one leads, so that the answer does not depend on the order of the pairs.
  void join(std::size_t i, std::size_t j) {
    const auto [first, second] = std::minmax({root(i), root(j)});
    parent_[second] = first;
  }

 private:
  std::vector<std::size_t> parent_;
};

class Dissolver {
 public:
  explicit Dissolver(Workspace& workspace) : workspace_(workspace), drafts_(workspace.drafts) {}

  void run() {
    find_solids();
    Groups groups(solids_.size());
    join_touching(groups);
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < solids_.size(); ++i) members[groups.root(i)].push_back(i);
    gone_.assign(drafts_.size(), false);
    for (const auto& [leader, group] : members) {
      if (group.size() > 1) unite(group);
    }
    drop_gone();
  }

 private:
  void find_solids() {
    std::map<std::size_t, std::size_t> solid_of;
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      if (drafts_[i].kind != FeatureKind::kSolid) continue;
      auto chain = chain_of_draft(drafts_[i]);
      if (drafts_[i].inner_of) {
        const auto outer = solid_of.find(*drafts_[i].inner_of);
        if (outer != solid_of.end()) solids_[outer->second].holes.push_back(i);
      } else if (chain && chain->closed) {
        solid_of[i] = solids_.size();
        solids_.push_back({i, {}, *std::move(chain)});
      }
    }
  }

  bool are_alike(const Solid& p, const Solid& q) const {
    return p.chain.style.height_m == q.chain.style.height_m &&
           p.chain.style.in_out == q.chain.style.in_out;
  }

  // By single edges, of outlines and holes: a house may fill a courtyard.
  void join_touching(Groups& groups) const {
    std::vector<IndexedSegment> edges;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      append_edges(solids_[i].outer, i, edges);
      for (const std::size_t hole : solids_[i].holes) append_edges(hole, i, edges);
    }
    const SegmentIndex index(std::move(edges));
    for (std::size_t e = 0; e < index.size(); ++e) {
      const auto& s = index[e];
      index.query_meeting(s.a, s.b, [&](std::size_t other) {
        const auto& t = index[other];
        if (s.tag >= t.tag || !are_alike(solids_[s.tag], solids_[t.tag])) return true;
        const auto kind = meet(s.a, s.b, t.a, t.b).kind;
        if (kind == Meeting::kOverlap || kind == Meeting::kCross) groups.join(s.tag, t.tag);
        return true;
      });
    }
  }

  void append_edges(std::size_t draft, std::size_t tag, std::vector<IndexedSegment>& edges) const {
    for (const auto& s : drafts_[draft].obstacle.segments) {
      edges.push_back({s.a, s.b, static_cast<std::uint32_t>(tag)});
    }
  }

  SimplePolygon polygon_of(const Solid& solid) const {
    SimplePolygon polygon{solid.chain.points, {}};
    for (const std::size_t hole : solid.holes) {
      polygon.holes.push_back(chain_points(drafts_[hole].obstacle));
    }
    return polygon;
  }

  void unite(const std::vector<std::size_t>& group) {
    std::vector<SimplePolygon> polygons;
    for (const std::size_t i : group) polygons.push_back(polygon_of(solids_[i]));
    const auto united = united_polygons(polygons, workspace_.snap());
    if (!united || united->empty()) return;
    const Draft leader = united_draft(group);
    tell(group, polygons, *united);
    for (const std::size_t i : group) {
      gone_[solids_[i].outer] = true;
      for (const std::size_t hole : solids_[i].holes) gone_[hole] = true;
    }
    const SegmentStyle style = solids_[group.front()].chain.style;
    for (const auto& polygon : *united) append(leader, polygon, style);
  }

  // The first one, with the labels that all have and the features of all.
  Draft united_draft(const std::vector<std::size_t>& group) const {
    Draft draft = drafts_[solids_[group.front()].outer];
    draft.obstacle.shape_type = ShapeType::kClosedPolygon;
    draft.features.clear();
    std::string labels;
    for (const auto token : draft.obstacle.semantic.tokens()) {
      const bool all = std::all_of(group.begin(), group.end(), [&](std::size_t i) {
        const auto tokens = drafts_[solids_[i].outer].obstacle.semantic.tokens();
        return std::find(tokens.begin(), tokens.end(), token) != tokens.end();
      });
      if (all) labels += (labels.empty() ? "" : ",") + std::string(token);
    }
    draft.obstacle.semantic = Semantic(labels.empty() ? "building" : labels);
    for (const std::size_t i : group) {
      const auto& features = drafts_[solids_[i].outer].features;
      draft.features.insert(draft.features.end(), features.begin(), features.end());
    }
    return draft;
  }

  void append(const Draft& leader, const SimplePolygon& polygon, const SegmentStyle& style) {
    Draft outer = leader;
    outer.obstacle.segments = chain_of(polygon.outer, true, style);
    const std::size_t position = drafts_.size();
    drafts_.push_back(std::move(outer));
    for (const auto& hole : polygon.holes) {
      Draft inner = leader;
      inner.inner_of = position;
      inner.obstacle.segments = chain_of(hole, true, style);
      drafts_.push_back(std::move(inner));
    }
    gone_.resize(drafts_.size(), false);
  }

  static double area_of(const std::vector<SimplePolygon>& polygons) {
    double area = 0.0;
    for (const auto& polygon : polygons) {
      area += std::abs(signed_area_m2(polygon.outer));
      for (const auto& hole : polygon.holes) area -= std::abs(signed_area_m2(hole));
    }
    return area;
  }

  void tell(const std::vector<std::size_t>& group, const std::vector<SimplePolygon>& before,
            const std::vector<SimplePolygon>& after) {
    Measures measures;
    measures.area_change_m2 = area_of(after) - area_of(before);
    for (const std::size_t i : group) {
      for (const std::size_t account : drafts_[solids_[i].outer].features) {
        workspace_.ledger.change(
            account, FindingCode::C252,
            "one outline with " + std::to_string(group.size() - 1) + " others that it touches",
            measures);
      }
    }
  }

  void drop_gone() {
    std::vector<std::size_t> moved(drafts_.size());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      moved[i] = kept;
      if (!gone_[i]) ++kept;
    }
    std::vector<Draft> left;
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      if (gone_[i]) continue;
      if (drafts_[i].inner_of) drafts_[i].inner_of = moved[*drafts_[i].inner_of];
      left.push_back(std::move(drafts_[i]));
    }
    drafts_ = std::move(left);
  }

  Workspace& workspace_;
  std::vector<Draft>& drafts_;
  std::vector<Solid> solids_;
  std::vector<bool> gone_;
};

}  // namespace

void dissolve_solids(Workspace& workspace) {
  Dissolver(workspace).run();
}

}  // namespace mapwright::converter
