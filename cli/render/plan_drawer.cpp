#include "cli/render/drawers.hpp"

namespace mapwright::cli {
namespace {

using converter::Colour;

constexpr Colour kTree = Colour::from_hex(0x2F6FAE, 0.85);
constexpr Colour kRaw = Colour::from_hex(0xD55E00);
constexpr Colour kPath = Colour::from_hex(0xB0005A);
constexpr Colour kShortest = Colour::from_hex(0x0B6E4F);
constexpr Colour kStart = Colour::from_hex(0x00694D);
constexpr Colour kBarrier = Colour::from_hex(0xE69F00);
constexpr Colour kGoal = Colour::from_hex(0xB0005A);

std::vector<Point> points_of(const Json& path) {
  std::vector<Point> points;
  for (const auto& xy : path) points.push_back(point_of(xy));
  return points;
}

void add_tree(const Json& query, converter::Overlay& overlay) {
  if (!query.contains("tree")) return;
  converter::OverlaySegments tree{{}, {kTree, 0.7}};
  for (const auto& edge : query.at("tree")) {
    tree.segments.emplace_back(Point{edge.at(0).get<double>(), edge.at(1).get<double>()},
                               Point{edge.at(2).get<double>(), edge.at(3).get<double>()});
  }
  add_legend(overlay, tree, "search tree");
  overlay.items.emplace_back(std::move(tree));
}

// The narrowest place on the way, and what proves that there is none.
void add_proofs(const Json& query, converter::Overlay& overlay) {
  if (query.contains("barrier")) {
    converter::OverlaySegments barrier{{}, {kBarrier, 2.0}};
    for (const auto& side : query.at("barrier")) {
      barrier.segments.emplace_back(Point{side.at(0).get<double>(), side.at(1).get<double>()},
                                    Point{side.at(2).get<double>(), side.at(3).get<double>()});
    }
    add_legend(overlay, barrier, "barrier: no way across for this robot");
    overlay.items.emplace_back(std::move(barrier));
  }
  if (!query.contains("bottleneck_at") || query.at("bottleneck_at").is_null()) return;
  const converter::OverlayDots dot{{point_of(query.at("bottleneck_at"))}, 2.6, kBarrier};
  add_legend(overlay, dot, "bottleneck: narrowest place of the widest way");
  overlay.items.emplace_back(dot);
}

void add_path(const Json& query, const char* key, const converter::Stroke& stroke,
              const char* meaning, converter::Overlay& overlay) {
  if (!query.contains(key) || query.at(key).empty()) return;
  converter::OverlayPath path{points_of(query.at(key)), stroke};
  if (meaning != nullptr) add_legend(overlay, path, meaning);
  overlay.items.emplace_back(std::move(path));
}

void add_place(const Json& xy, double radius_pt, Colour colour, const char* meaning,
               converter::Overlay& overlay) {
  if (xy.is_null()) return;  // a named place without room for the robot
  const converter::OverlayDots rim{{point_of(xy)}, radius_pt + 1.0, Colour::from_hex(0xFFFFFF)};
  const converter::OverlayDots dot{{point_of(xy)}, radius_pt, colour};
  add_legend(overlay, dot, meaning);
  overlay.items.insert(overlay.items.end(), {rim, dot});
}

}  // namespace

void draw_plan(const Json& answer, converter::Overlay& overlay) {
  // Another colour, so that the exact answer can be laid over that of a random planner.
  const bool is_exact = answer.value("planner", "") == "exact";
  const converter::Stroke stroke{is_exact ? kShortest : kPath, 2.0};
  const char* meaning = is_exact ? "shortest path" : "path";
  for (const auto& query : answer.at("queries")) {
    add_tree(query, overlay);
    add_path(query, "raw_path", {kRaw, 1.2, {3.0, 2.0}}, "path as found", overlay);
    add_path(query, "path", {Colour::from_hex(0xFFFFFF, 0.8), 3.6}, nullptr, overlay);
    add_path(query, "path", stroke, meaning, overlay);
    add_proofs(query, overlay);
    add_place(query.at("start"), 3.2, kStart, "start", overlay);
    add_place(query.at("goal"), 3.2, kGoal, "goal", overlay);
  }
}

}  // namespace mapwright::cli
