// Writes many small maps for bench/batch.sh: generated campuses of 25 m to 40 m, every seventh with
// a decimal comma, every eleventh all one block that a robot cannot enter.
// Usage: make_maps FOLDER COUNT
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "bench/support/campus_generator.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::bench {
namespace {

Map block(double side_m) {
  const Point corners[] = {{0, 0}, {side_m, 0}, {side_m, side_m}, {0, side_m}};
  Obstacle obstacle{1, ShapeType::kClosedPolygon, "building", {}};
  for (std::size_t i = 0; i < 4; ++i) {
    obstacle.segments.push_back({corners[i], corners[(i + 1) % 4], 3.0, InOut::kOutdoor, "wall"});
  }
  Map map;
  map.border = {0, side_m, side_m, 0};  // left, top, right, bottom
  map.obstacles = {obstacle};
  return map;
}

std::string map_text(std::size_t number) {
  const double side_m = 25.0 + static_cast<double>(number % 16);
  if (number % 11 == 10) return format_map(block(side_m));
  std::string text = format_map(generate_campus({side_m, 40 + number % 50, number}));
  if (number % 7 == 6) text.replace(text.rfind('.'), 1, ",");
  return text;
}

void write_maps(const std::filesystem::path& folder, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto district = folder / ("district-" + std::to_string(i % 10));
    std::filesystem::create_directories(district);
    std::ofstream(district / ("site-" + std::to_string(i) + ".txt"), std::ios::binary)
        << map_text(i);
  }
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make_maps FOLDER COUNT\n";
    return 2;
  }
  mapwright::bench::write_maps(argv[1], std::strtoull(argv[2], nullptr, 10));
}
