// A made-up campus of any size, for benchmarks and large tests.
#pragma once

#include <cstddef>
#include <cstdint>

#include "mapcore/map.hpp"

namespace mapwright::bench {

struct CampusOptions {
  double side_m = 100.0;       ///< of the square, its lower left corner at (0, 0); at least 25
  std::size_t segments = 520;  ///< exactly so many
  std::uint64_t seed = 1;
};

/// The sizes figures are quoted for: the report's density, 520 segments on 10,000 m².
inline constexpr CampusOptions kCampus100m{100.0, 520, 1};
inline constexpr CampusOptions kCampus1km{1000.0, 52'000, 1};
inline constexpr CampusOptions kCampus10km{10'000.0, 5'200'000, 1};

/// A map without defects: buildings with 4 to 12 corners (counter-clockwise), columns, benches of
/// 0.5 m, open walls, some stairs and ramps, all on a millimetre grid, none overlapping. The same
/// options give the same map everywhere.
Map generate_campus(const CampusOptions& options);

}  // namespace mapwright::bench
