// Writes a made-up campus of so many segments, for pages that must stay smooth.
// Usage: make_campus SEGMENTS > MAP.txt
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "bench/support/campus_generator.hpp"
#include "mapcore/text/writer.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_campus SEGMENTS > MAP.txt\n";
    return 2;
  }
  const auto segments = static_cast<std::size_t>(std::atoll(argv[1]));
  // The report's density: 520 segments on 10,000 m².
  const double side_m = std::max(25.0, std::sqrt(static_cast<double>(segments) / 0.052));
  mapwright::write_map(mapwright::bench::generate_campus({side_m, segments, 1}), std::cout);
  return std::cout.flush() ? 0 : 1;
}
