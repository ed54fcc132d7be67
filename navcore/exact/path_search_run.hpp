// Private to this folder: One run of the search for a shortest path; used by path_search.cpp and
// path_views.cpp only.
#pragma once

#include <limits>

#include "navcore/exact/path_search.hpp"

namespace mapwright::navcore::exact {

/// One run of the search.
class PathSearch {
 public:
  PathSearch(const CellMesh& mesh, GridPoint goal, SearchSpace& space)
      : mesh_(mesh), corners_(mesh.corners()), goal_(goal), space_(space) {
    space_.begin(mesh);
  }

  std::optional<GridPath> run(GridPoint start, std::span<const std::uint32_t> start_cells,
                              std::span<const std::uint32_t> goal_cells);

 private:
  using Node = SearchSpace::Node;
  using Ray = SearchSpace::Ray;
  using Root = SearchSpace::Root;
  using Queued = SearchSpace::Queued;

  // What is seen of a chain of sides: w_[0] is the right end of the entered side, w_[last] its left
  // end; side s runs from w_[s] to w_[s + 1].
  struct Chain {
    std::uint32_t first, end;  // corners of the cell
    std::uint32_t offset;      // w_[0] is corner first + offset
    std::uint32_t sides;       // without the entered one
    std::uint32_t corner(std::uint32_t i) const {
      const std::uint32_t at = first + offset + i;
      return at < end ? at : at - (end - first);
    }
  };

  // Where one ray leaves a cell.
  struct Sight {
    std::uint32_t bound;  // right: first side seen, at least in part; left: end of those seen
    bool at_end;          // the ray leaves through an end of a side
    bool hides_any;       // there are sides between the entered one's end and the ray
  };

  void mark_goal(std::span<const std::uint32_t> goal_cells);
  void start_in(std::uint32_t cell);
  std::optional<GridPath> search();
  void expand(Node node);
  void find_successors(const Node& node);
  void see_all(const Node& node, const Chain& chain);
  void see_cone(const Node& node, const Chain& chain);
  Sight right_sight(const Node& node, const Chain& chain) const;
  Sight left_sight(const Node& node, const Chain& chain) const;
  void see_side(const Node& node, std::uint32_t corner, bool right_is_end, bool left_is_end);
  void turn_right(const Node& node, const Chain& chain, const Sight& sight);
  void turn_left(const Node& node, const Chain& chain, const Sight& sight);
  void look_through(std::uint32_t root, std::uint32_t corner);
  void look_along(std::uint32_t root, std::uint32_t corner);
  void reach_goal(const Node& node);
  void finish(std::uint32_t root);
  void add(Node node);
  void enqueue(const Node& node);
  bool may_enter(std::uint32_t corner) const;
  std::optional<std::uint32_t> turn_at(std::uint32_t root, std::uint32_t corner);
  bool is_outdone(const Root& root) const;
  double estimate(const Node& node) const;
  Point meet(const Ray& ray, GridPoint p, GridPoint q) const;
  Chain chain_behind(std::int32_t corner) const;
  const Corner& at(std::uint32_t corner) const { return corners_[corner]; }
  const Corner& after(std::uint32_t corner) const;
  GridPath path_to(std::uint32_t root) const;

  const CellMesh& mesh_;
  std::span<const Corner> corners_;
  GridPoint goal_;
  SearchSpace& space_;
};

}  // namespace mapwright::navcore::exact
