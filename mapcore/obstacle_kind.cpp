#include "mapcore/obstacle_kind.hpp"

#include <algorithm>
#include <array>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright {
namespace {

constexpr double kHigh_m = 2.5;         // buildings, columns, lamp posts
constexpr double kLowWall_m = 0.5;      // the height robots mount their lasers at
constexpr double kColumnArea_m2 = 4.0;  // a pillar is smaller than a room

constexpr std::array<std::string_view, 8> kGreenLabels = {"tree", "hedge", "planter", "flowerpot",
                                                          "bush", "plant", "arbre",   "jardinera"};
constexpr std::array<std::string_view, 4> kColumnLabels = {"column", "pillar", "post", "columna"};

constexpr std::array<std::string_view, 9> kNames = {
    "ramp",   "stairs",          "low obstacle", "plants",  "building",
    "column", "courtyard, room", "wall, fence",  "low wall"};

template <std::size_t n>
bool has_one_of(const Obstacle& obstacle, const std::array<std::string_view, n>& labels) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](std::string_view label) { return obstacle.semantic.has_label(label); });
}

ObstacleKind solid_kind(const Obstacle& obstacle) {
  const double area_m2 = signed_area_m2(chain_points(obstacle));
  if (area_m2 < 0.0) return ObstacleKind::kRoom;
  if (has_one_of(obstacle, kGreenLabels)) return ObstacleKind::kGreen;
  if (max_height_m(obstacle) < kHigh_m) return ObstacleKind::kLowSolid;
  if (has_one_of(obstacle, kColumnLabels)) return ObstacleKind::kColumn;
  return area_m2 < kColumnArea_m2 ? ObstacleKind::kColumn : ObstacleKind::kBuilding;
}

}  // namespace

ObstacleKind obstacle_kind(const Obstacle& obstacle) {
  if (obstacle.shape_type == ShapeType::kStairs) return ObstacleKind::kStairs;
  if (obstacle.shape_type == ShapeType::kRamp) return ObstacleKind::kRamp;
  if (is_closed(obstacle.shape_type)) return solid_kind(obstacle);
  return max_height_m(obstacle) < kLowWall_m ? ObstacleKind::kLowWall : ObstacleKind::kWall;
}

std::string_view to_string(ObstacleKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

const std::vector<ObstacleKind>& all_obstacle_kinds() {
  static const std::vector<ObstacleKind> kinds = {
      ObstacleKind::kBuilding, ObstacleKind::kColumn, ObstacleKind::kRoom,
      ObstacleKind::kLowSolid, ObstacleKind::kGreen,  ObstacleKind::kWall,
      ObstacleKind::kLowWall,  ObstacleKind::kStairs, ObstacleKind::kRamp};
  return kinds;
}

}  // namespace mapwright
