// Generated maps for tests: everything the format can hold, nothing a reader may rely on.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/random.hpp"

namespace mapwright::test {

struct RandomMapOptions {
  std::size_t most_obstacles = 6;
  std::size_t most_segments = 9;  ///< an obstacle
};

namespace detail {

/// Mostly campus-like, sometimes tiny, exactly on a tie of the grid, or beyond all reason.
inline double random_number(Random& random) {
  switch (random.below(12)) {
    case 0:
      return 0.0;
    case 1:
      return -0.0;
    case 2:
      return random.uniform(-1e-3, 1e-3);
    case 3:
      return static_cast<double>(random.below(4000)) * 0.0005 - 1.0;
    case 4:
      return std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(200)) - 80);
    case 5:
      return random.uniform(-1e300, 1e300);
    case 6:
      return std::round(random.uniform(-1e7, 1e7));
    default:
      return random.uniform(-1000.0, 1000.0);
  }
}

inline std::string random_semantic(Random& random) {
  static const std::vector<std::string> words{"wall",
                                              "brick",
                                              "column",
                                              "A5",
                                              "flowerpot",
                                              "obstacle",
                                              "border",
                                              "inner_of=3",
                                              "normal=0:0.1:0.995",
                                              "name=Plaça de l'Àgora",
                                              "建物",
                                              "🤖",
                                              "",
                                              " ",
                                              "\t",
                                              "level=-1",
                                              "1,5",
                                              "\"",
                                              "\xC2\xA0",
                                              "obstacle 26",
                                              ".",
                                              "0"};
  std::string text;
  for (std::uint64_t left = random.below(5); left > 0; --left) {
    text += words[random.below(words.size())];
    if (left > 1) text += random.below(4) == 0 ? " " : ",";
  }
  return text;
}

inline Segment random_segment(Random& random) {
  Segment segment;
  segment.a = {random_number(random), random_number(random)};
  segment.b = {random_number(random), random_number(random)};
  segment.height_m = random_number(random);
  segment.in_out = random.below(2) == 0 ? InOut::kIndoor : InOut::kOutdoor;
  segment.semantic = random_semantic(random);
  return segment;
}

}  // namespace detail

/// Any map: all shape types, odd semantic strings in UTF-8, extreme numbers, chains that need not
/// join. Numbers are finite and semantic strings without ';', '#' and line breaks.
inline Map random_map(Random& random, const RandomMapOptions& options = {}) {
  Map map;
  map.border = {detail::random_number(random), detail::random_number(random),
                detail::random_number(random), detail::random_number(random)};
  map.obstacles.resize(random.below(options.most_obstacles + 1));
  for (auto& obstacle : map.obstacles) {
    obstacle.id =
        static_cast<std::int64_t>(random() >> random.below(64)) * (random.below(9) == 0 ? -1 : 1);
    obstacle.shape_type = static_cast<ShapeType>(1 + random.below(6));
    obstacle.semantic = detail::random_semantic(random);
    obstacle.segments.resize(random.below(options.most_segments + 1));
    for (auto& segment : obstacle.segments) segment = detail::random_segment(random);
  }
  return map;
}

}  // namespace mapwright::test
