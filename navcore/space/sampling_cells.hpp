// Where to draw points from, most of them free.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mapcore/point.hpp"
#include "mapcore/random.hpp"

namespace mapwright::navcore {

/// What is known of a square of the plane.
enum class CellState { kFree, kSolid, kMixed };

/// A subdivision of a box into cells that are free and cells that may be; solid ones are left out.
///
/// Splits until half of the remaining area is proved free, or the cells are many.
class SamplingCells {
 public:
  SamplingCells(const Box& box, const std::function<CellState(const Box&)>& classify);

  /// Uniform over the remaining cells; nothing where none remains.
  std::optional<Point> draw(Random& random) const;

 private:
  struct Cell {
    Box box;
    bool free = false;
  };
  void split_mixed(const std::function<CellState(const Box&)>& classify);
  bool is_good_enough() const;

  std::vector<Cell> cells_;
  std::vector<double> cumulated_area_m2_;
};

}  // namespace mapwright::navcore
