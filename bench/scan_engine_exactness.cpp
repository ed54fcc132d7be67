// How exact the scan engine is, on generated campuses and on map files.
//
// scan_engine_exactness [RAYS] [MAP.txt...]: that many rays for each map and instruction set
// (default 2,500,000), at five laser heights, half of the poses anywhere and half in clusters, over
// 360°, and half as many again in clusters over 180°, compared with double precision.
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/ray_exactness.hpp"
#include "mapcore/text/reader.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "navcore/rays/culled_ray_caster.hpp"

namespace mapwright::bench {
namespace {

using navcore::LaserModel;
using navcore::ScanEngine;

struct NamedMap {
  std::string name;
  Map map;
};

Exactness measure(const NamedMap& named, std::string_view instruction_set, std::size_t rays) {
  constexpr double kHeights[] = {0.05, 0.3, 0.5, 1.0, 1.9};
  navcore::ScanEngineOptions options;
  options.instruction_set = std::string(instruction_set);
  const ScanEngine engine(named.map, options);
  const navcore::CulledRayCaster reference(named.map);
  Exactness all;
  std::uint64_t seed = 1;
  for (const double height : kHeights) {
    const LaserModel laser{361, 360.0, 15.0, height};
    const std::size_t half = rays / std::size(kHeights) / laser.rays / 2;
    for (const auto& poses :
         {poses_everywhere(named.map, half, ++seed), poses_in_clusters(named.map, half, seed)}) {
      all.add(measure_exactness(named.map, engine, reference, poses, laser));
    }
    const LaserModel ahead{181, 180.0, 15.0, height};
    all.add(measure_exactness(named.map, engine, reference,
                              poses_in_clusters(named.map, half, seed + 100), ahead));
  }
  return all;
}

void print(const NamedMap& named, std::string_view set, const Exactness& e) {
  std::printf("%-24s %-8s %10zu %10zu %9zu %6zu %12.2e %12.2e\n", named.name.c_str(),
              std::string(set).c_str(), e.rays, e.stopped, e.grazing, e.wrong, e.worst_error_m,
              e.worst_scaled_m);
  if (e.wrong > 0) std::printf("  %s\n", e.first_wrong.c_str());
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

int main_of(std::size_t rays, const std::vector<std::string>& files) {
  std::vector<NamedMap> maps;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    maps.push_back({"campus " + std::to_string(seed), generate_campus({100.0, 520, seed})});
  }
  maps.push_back({"dense campus", generate_campus({60.0, 600, 4})});
  for (const auto& file : files) maps.push_back({file, read_map(text_of(file)).map});
  std::printf("%srays of 15 m; error in metres; grazing as in ray_exactness.hpp\n",
              machine_description().c_str());
  std::printf("%-24s %-8s %10s %10s %9s %6s %12s %12s\n", "map", "set", "rays", "stopped",
              "grazing", "wrong", "worst", "worst x sin");
  std::size_t wrong = 0;
  for (const NamedMap& named : maps) {
    for (const auto set : ScanEngine::instruction_sets()) {
      const Exactness result = measure(named, set, rays);
      print(named, set, result);
      wrong += result.wrong;
    }
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace mapwright::bench

int main(int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  std::size_t rays = 2'500'000;
  if (!words.empty()) {
    const std::string& first = words.front();
    const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), rays);
    if (error == std::errc{}) words.erase(words.begin());
  }
  return mapwright::bench::main_of(rays, words);
}
