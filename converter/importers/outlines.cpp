#include "converter/importers/outlines.hpp"

#include <array>
#include <utility>

namespace mapwright::converter {
namespace {

enum Side : std::uint8_t { kSouth, kEast, kNorth, kWest, kNone };
using Step = std::pair<Side, Side>;

// Steps across the square between four cell centres, by which of them are occupied (1: lower left,
// 2: lower right, 4: upper right, 8: upper left); what is occupied lies on the left. The two cases
// of opposite corners join the occupied ones.
constexpr Step kNoStep{kNone, kNone};
constexpr std::array<std::array<Step, 2>, 16> kSteps{{
    {kNoStep, kNoStep},
    {Step{kSouth, kWest}, kNoStep},
    {Step{kEast, kSouth}, kNoStep},
    {Step{kEast, kWest}, kNoStep},
    {Step{kNorth, kEast}, kNoStep},
    {Step{kSouth, kEast}, Step{kNorth, kWest}},
    {Step{kNorth, kSouth}, kNoStep},
    {Step{kNorth, kWest}, kNoStep},
    {Step{kWest, kNorth}, kNoStep},
    {Step{kSouth, kNorth}, kNoStep},
    {Step{kEast, kNorth}, Step{kWest, kSouth}},
    {Step{kEast, kNorth}, kNoStep},
    {Step{kWest, kEast}, kNoStep},
    {Step{kSouth, kEast}, kNoStep},
    {Step{kWest, kSouth}, kNoStep},
    {kNoStep, kNoStep},
}};

// One more cell, not occupied, all around.
class Tracer {
 public:
  explicit Tracer(const OccupancyGrid& grid)
      : grid_(grid), width_(2 * grid.columns + 3), next_(width_ * (2 * grid.rows + 3), 0) {
    for (std::size_t row = 0; row <= grid.rows; ++row) {
      for (std::size_t column = 0; column <= grid.columns; ++column) link(column, row);
    }
  }

  std::vector<LatticeRing> rings() {
    std::vector<LatticeRing> result;
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] == 0) continue;
      LatticeRing ring;
      for (std::size_t at = start; next_[at] != 0;) {
        ring.push_back(point(at));
        at = std::exchange(next_[at], 0);
      }
      result.push_back(std::move(ring));
    }
    return result;
  }

 private:
  bool is_occupied(std::size_t column, std::size_t row) const {  // both counted from 1
    return column > 0 && row > 0 && column <= grid_.columns && row <= grid_.rows &&
           grid_.at(column - 1, row - 1) == Cell::kOccupied;
  }

  void link(std::size_t column, std::size_t row) {
    const unsigned corners =
        (is_occupied(column, row) ? 1U : 0U) | (is_occupied(column + 1, row) ? 2U : 0U) |
        (is_occupied(column + 1, row + 1) ? 4U : 0U) | (is_occupied(column, row + 1) ? 8U : 0U);
    for (const auto& [from, to] : kSteps[corners]) {
      if (from != kNone) next_[node(column, row, from)] = node(column, row, to);
    }
  }

  // Middle of a side of the square whose lower left corner is the centre of a cell.
  std::size_t node(std::size_t column, std::size_t row, Side side) const {
    const std::size_t x = 2 * column + (side == kEast ? 2 : side == kWest ? 0 : 1);
    const std::size_t y = 2 * row + (side == kNorth ? 2 : side == kSouth ? 0 : 1);
    return y * width_ + x;
  }

  Point point(std::size_t node) const {
    return {static_cast<double>(node % width_) - 2.0, static_cast<double>(node / width_) - 2.0};
  }

  const OccupancyGrid& grid_;
  std::size_t width_;
  std::vector<std::size_t> next_;  ///< of each node; 0 (a corner, never a node): none
};

}  // namespace

std::vector<LatticeRing> occupied_outlines(const OccupancyGrid& grid) {
  return Tracer(grid).rings();
}

}  // namespace mapwright::converter
