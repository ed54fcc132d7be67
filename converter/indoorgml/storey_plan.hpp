// Private to this folder: what stands on one floor.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "converter/indoorgml/storeys.hpp"
#include "converter/indoorgml/wall_lines.hpp"

namespace mapwright::converter {

enum class IndoorRole { kRoom, kObject, kWall, kOpening };

/// What an object is to a robot: a cell that cannot be entered (NonNavigableSpace, an obstacle) is
/// an object, every other cell a room; a boundary is an opening if it is of a kind to pass through,
/// or the dual of a transition of the graph, and no window.
IndoorRole role_of_cell(const IndoorObject& cell);
IndoorRole role_of_boundary(const IndoorObject& boundary,
                            const std::unordered_set<std::string>& duals_of_transitions);

/// The walls of one storey.
class StoreyPlan {
 public:
  /// Borrows all but the storey. `tolerance` as of WallRules.
  StoreyPlan(const IndoorDocument& document,
             const std::vector<std::optional<Footprint>>& footprints, Storey storey,
             double metres_per_unit);

  const Storey& storey() const { return storey_; }
  bool is_opening(std::size_t boundary) const { return openings_.count(boundary) > 0; }
  std::vector<std::vector<Point>> walls_of_cell(std::size_t cell) const;
  std::vector<std::vector<Point>> walls_of_boundary(std::size_t boundary) const;

  /// What is to be told of a boundary that is a door: that it lies beside the wall it opens, or at
  /// none. Empty where it lies on a wall.
  std::string remark_about_door(std::size_t boundary) const;
  /// Ids of doors at no wall, as far as they have any.
  const std::vector<std::string>& idle_doors() const { return idle_doors_; }

  /// How far the floor of a cell that is no room is above the rooms' around it; 0 where heights are
  /// not known.
  double sill_of_cell(std::size_t cell) const;

 private:
  bool is_ground(std::size_t cell) const;
  double ground_at(const Box& box, double z) const;
  bool is_way(std::size_t cell) const;
  bool are_open(std::size_t cell, std::size_t other) const;
  void find_openings();
  void join_cells_of_transitions();
  std::vector<WallEdge> edges() const;
  void fit_doors(const std::vector<WallEdge>& edges, WallRules& rules);
  void remark(std::size_t boundary, bool opens, double farthest_m);

  const IndoorDocument& document_;
  const std::vector<std::optional<Footprint>>& footprints_;
  Storey storey_;
  double metres_per_unit_;
  std::unordered_set<std::size_t> openings_;                 // boundaries
  std::vector<std::size_t> grounds_;                         // cells that are rooms
  std::unordered_set<std::size_t> ways_;                     // cells that are doors
  std::vector<std::pair<std::size_t, std::size_t>> joined_;  // sorted pairs of cells
  std::unique_ptr<WallLines> lines_;
  std::vector<WallEdge> jambs_;                           // of doors through thick walls
  std::unordered_map<std::size_t, std::string> remarks_;  // by boundary
  std::vector<std::string> idle_doors_;
};

/// The ground line of a boundary: of a standing polygon its longest stretch seen from above.
std::vector<std::vector<Point>> ground_lines(const IndoorObject& boundary);

}  // namespace mapwright::converter
