#include "navcore/localization/place_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mapwright::navcore {
namespace {

constexpr double kCell_m = 1.0;
constexpr double kCell_deg = 20.0;

}  // namespace

PlaceCell place_cell(const Pose& pose) {
  const auto number = [](double value, double size) {
    return static_cast<std::int64_t>(std::floor(value / size));
  };
  return {number(pose.x, kCell_m), number(pose.y, kCell_m),
          number(pose.theta.wrapped().degrees(), kCell_deg)};
}

CellOrder sorted_into_cells(std::span<const Pose> poses) {
  std::vector<std::pair<PlaceCell, std::uint32_t>> keyed(poses.size());
  for (std::uint32_t i = 0; i < poses.size(); ++i) keyed[i] = {place_cell(poses[i]), i};
  std::sort(keyed.begin(), keyed.end());
  CellOrder cells;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].first != keyed[i - 1].first) cells.begins.push_back(i);
    cells.order.push_back(keyed[i].second);
  }
  cells.begins.push_back(keyed.size());
  return cells;
}

}  // namespace mapwright::navcore
