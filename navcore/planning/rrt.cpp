#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "navcore/planning/planner.hpp"
#include "navcore/planning/search_tree.hpp"

namespace mapwright::navcore {
namespace {

// The steps of one iteration: sample, nearest, connect.
class Grower {
 public:
  Grower(const FreeSpace& space, const PlanQuery& query, const RrtOptions& options, Random& random)
      : space_(space), query_(query), options_(options), random_(random) {
    assert(space.is_free(query.start, query.radius_m) && space.is_free(query.goal, query.radius_m));
  }

  // A random free point, or now and then the target; nothing where no free space is found.
  std::optional<Point> sample(Point target) {
    if (options_.goal_bias > 0.0 && random_.uniform() < options_.goal_bias) return target;
    return space_.sample(random_, query_.radius_m);
  }

  // The nearest node of the tree that sees p.
  std::optional<SearchTree::Node> nearest_in_sight(const SearchTree& tree, Point p) const {
    for (const auto node : tree.nearest(p)) {
      if (sees(tree.point(node), p)) return node;
    }
    return std::nullopt;
  }

  // Connects p to the tree; with a range limit, a point that far on the way from the nearest node.
  std::optional<SearchTree::Node> connect(SearchTree& tree, Point p) const {
    if (options_.max_extension_m > 0.0) return extend(tree, p);
    const auto node = nearest_in_sight(tree, p);
    if (!node) return std::nullopt;
    return tree.add(p, *node);
  }

  bool sees(Point a, Point b) const { return space_.is_free_way(a, b, query_.radius_m); }

 private:
  std::optional<SearchTree::Node> extend(SearchTree& tree, Point p) const {
    const SearchTree::Node node = *tree.nearest(p).begin();
    const Point from = tree.point(node);
    const double way_m = distance(from, p);
    if (way_m == 0.0) return std::nullopt;
    if (way_m > options_.max_extension_m)
      p = from + (options_.max_extension_m / way_m) * (p - from);
    if (!space_.is_free(p, query_.radius_m) || !sees(from, p)) return std::nullopt;
    return tree.add(p, node);
  }

  const FreeSpace& space_;
  const PlanQuery& query_;
  const RrtOptions& options_;
  Random& random_;
};

PlanningResult direct_way(const PlanQuery& query) {
  PlanningResult result;
  result.solved = true;
  result.path = {query.start, query.goal};
  return result;
}

// Root of `from_start` … node, then node of the other tree … its root.
std::vector<Point> joined(const SearchTree& from_start, SearchTree::Node start_node,
                          const SearchTree& from_goal, SearchTree::Node goal_node) {
  std::vector<Point> path = from_start.path_to_root(start_node);
  std::reverse(path.begin(), path.end());
  const auto rest = from_goal.path_to_root(goal_node);
  path.insert(path.end(), rest.begin(), rest.end());
  return path;
}

}  // namespace

PlanningResult plan_rrt(const FreeSpace& space, const PlanQuery& query, const RrtOptions& options,
                        Random& random) {
  Grower grower(space, query, options, random);
  if (grower.sees(query.start, query.goal)) return direct_way(query);
  PlanningResult result;
  SearchTree tree(query.start);
  while (!result.solved && result.iterations < options.max_iterations) {
    const auto p = grower.sample(query.goal);
    if (!p) break;
    ++result.iterations;
    const auto added = grower.connect(tree, *p);
    if (!added || !grower.sees(tree.point(*added), query.goal)) continue;
    result.solved = true;
    result.path = joined(tree, *added, SearchTree(query.goal), 0);
  }
  tree.append_edges(result.tree);
  return result;
}

PlanningResult plan_balanced_rrt(const FreeSpace& space, const PlanQuery& query,
                                 const RrtOptions& options, Random& random) {
  Grower grower(space, query, options, random);
  if (grower.sees(query.start, query.goal)) return direct_way(query);
  PlanningResult result;
  std::array<SearchTree, 2> trees{SearchTree(query.start), SearchTree(query.goal)};
  const std::array<Point, 2> targets{query.goal, query.start};
  while (!result.solved && result.iterations < options.max_iterations) {
    const std::size_t own = result.iterations % 2;
    const auto p = grower.sample(targets[own]);
    if (!p) break;
    ++result.iterations;
    const auto added = grower.connect(trees[own], *p);
    if (!added) continue;
    const auto met = grower.nearest_in_sight(trees[1 - own], trees[own].point(*added));
    if (!met) continue;
    result.solved = true;
    const auto [start_node, goal_node] =
        own == 0 ? std::pair(*added, *met) : std::pair(*met, *added);
    result.path = joined(trees[0], start_node, trees[1], goal_node);
  }
  for (const auto& tree : trees) tree.append_edges(result.tree);
  return result;
}

}  // namespace mapwright::navcore
