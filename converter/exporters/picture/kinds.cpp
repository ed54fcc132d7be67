#include "converter/exporters/picture/kinds.hpp"

#include <algorithm>
#include <array>

namespace mapwright::converter {
namespace {

// Hues of Okabe and Ito's set, which people with any kind of colour blindness tell apart; fills are
// pale tints of them so that what is laid over the map stands out.
constexpr std::array<KindStyle, 9> kStyles = {{
    {Colour::from_hex(0xE9D5E4), Colour::from_hex(0x8F4A78), 0.7},       // ramp
    {Colour::from_hex(0xF8E3AE), Colour::from_hex(0x8A6100), 0.6},       // stairs
    {Colour::from_hex(0xB4D2E9), Colour::from_hex(0x124F7C), 0.7},       // low obstacle
    {Colour::from_hex(0xA6D5C0), Colour::from_hex(0x00694D), 0.7},       // plants
    {Colour::from_hex(0xDDD3C3), Colour::from_hex(0x4A4038), 1.1},       // building
    {Colour::from_hex(0x6A5D52), Colour::from_hex(0x3B322B), 0.7},       // column
    {Colour::from_hex(0xFFFFFF, 0.0), Colour::from_hex(0x4A4038), 1.1},  // courtyard, room
    {Colour::from_hex(0xFFFFFF, 0.0), Colour::from_hex(0xA8400B), 1.5},  // wall, fence
    {Colour::from_hex(0xFFFFFF, 0.0), Colour::from_hex(0xD98548), 1.1},  // low wall
}};

Colour mix(const Colour& a, const Colour& b, double t) {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue), a.opacity + t * (b.opacity - a.opacity)};
}

}  // namespace

const KindStyle& kind_style(ObstacleKind kind) {
  return kStyles[static_cast<std::size_t>(kind)];
}

Colour fill_colour(const Obstacle& obstacle, ObstacleKind kind) {
  const Colour fill = kind_style(kind).fill;
  if (kind != ObstacleKind::kBuilding) return fill;
  constexpr double kHighest_m = 30.0;
  return mix(fill, Colour::from_hex(0x9A8466), std::min(max_height_m(obstacle) / kHighest_m, 1.0));
}

}  // namespace mapwright::converter
