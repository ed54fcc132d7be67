#include "converter/exporters/picture/kinds.hpp"

#include <algorithm>
#include <array>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

constexpr double kHigh_m = 2.5;         // buildings, columns, lamp posts
constexpr double kLowWall_m = 0.5;      // the height robots mount their lasers at
constexpr double kColumnArea_m2 = 4.0;  // a pillar is smaller than a room

constexpr std::array<std::string_view, 8> kGreenLabels = {"tree", "hedge", "planter", "flowerpot",
                                                          "bush", "plant", "arbre",   "jardinera"};

// Hues of Okabe and Ito's set, which people with any kind of colour blindness tell apart; fills are
// pale tints of them so that what is laid over the map stands out.
constexpr std::array<KindStyle, 9> kStyles = {{
    {"ramp", Colour::from_hex(0xE9D5E4), Colour::from_hex(0x8F4A78), 0.7},
    {"stairs", Colour::from_hex(0xF8E3AE), Colour::from_hex(0x8A6100), 0.6},
    {"low obstacle", Colour::from_hex(0xB4D2E9), Colour::from_hex(0x124F7C), 0.7},
    {"plants", Colour::from_hex(0xA6D5C0), Colour::from_hex(0x00694D), 0.7},
    {"building", Colour::from_hex(0xDDD3C3), Colour::from_hex(0x4A4038), 1.1},
    {"column", Colour::from_hex(0x6A5D52), Colour::from_hex(0x3B322B), 0.7},
    {"courtyard, room", Colour::from_hex(0xFFFFFF, 0.0), Colour::from_hex(0x4A4038), 1.1},
    {"wall, fence", Colour::from_hex(0xFFFFFF, 0.0), Colour::from_hex(0xA8400B), 1.5},
    {"low wall", Colour::from_hex(0xFFFFFF, 0.0), Colour::from_hex(0xD98548), 1.1},
}};

constexpr std::array<std::string_view, 4> kColumnLabels = {"column", "pillar", "post", "columna"};

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

Colour mix(const Colour& a, const Colour& b, double t) {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue), a.opacity + t * (b.opacity - a.opacity)};
}

}  // namespace

ObstacleKind obstacle_kind(const Obstacle& obstacle) {
  if (obstacle.shape_type == ShapeType::kStairs) return ObstacleKind::kStairs;
  if (obstacle.shape_type == ShapeType::kRamp) return ObstacleKind::kRamp;
  if (is_closed(obstacle.shape_type)) return solid_kind(obstacle);
  return max_height_m(obstacle) < kLowWall_m ? ObstacleKind::kLowWall : ObstacleKind::kWall;
}

const KindStyle& kind_style(ObstacleKind kind) {
  return kStyles[static_cast<std::size_t>(kind)];
}

const std::vector<ObstacleKind>& all_obstacle_kinds() {
  static const std::vector<ObstacleKind> kinds = {
      ObstacleKind::kBuilding, ObstacleKind::kColumn, ObstacleKind::kRoom,
      ObstacleKind::kLowSolid, ObstacleKind::kGreen,  ObstacleKind::kWall,
      ObstacleKind::kLowWall,  ObstacleKind::kStairs, ObstacleKind::kRamp};
  return kinds;
}

Colour fill_colour(const Obstacle& obstacle, ObstacleKind kind) {
  const Colour fill = kind_style(kind).fill;
  if (kind != ObstacleKind::kBuilding) return fill;
  constexpr double kHighest_m = 30.0;
  return mix(fill, Colour::from_hex(0x9A8466), std::min(max_height_m(obstacle) / kHighest_m, 1.0));
}

}  // namespace mapwright::converter
