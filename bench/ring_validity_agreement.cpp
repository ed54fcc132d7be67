// Whether "is this ring valid?" has one answer: is_simple_ring, GEOS, and CGAL's exact arithmetic,
// asked about random rings of which most are degenerate. Disagreements that
// docs/decisions/0013-validity-of-rings.md does not explain are printed; then the program exits
// with 1.
//
// Usage: ring_validity_agreement [RINGS [SEED]]   (default 1,000,000 and 1)
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "bench/support/machine.hpp"
#include "bench/support/ring_agreement.hpp"

namespace mapwright::bench {
namespace {

void print_table(const RingAgreement& agreement) {
  std::cout << std::left << std::setw(20) << "rings" << std::right;
  for (std::size_t o = 0; o < kRingOutcomes; ++o) {
    std::cout << std::setw(24) << to_string(static_cast<RingOutcome>(o));
  }
  std::cout << '\n';
  for (std::size_t k = 0; k < kRingKinds; ++k) {
    std::cout << std::left << std::setw(20) << to_string(static_cast<RingKind>(k)) << std::right;
    for (const auto count : agreement.counts[k]) std::cout << std::setw(24) << count;
    std::cout << '\n';
  }
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  using namespace mapwright::bench;
  const std::uint64_t rings = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::cout << machine_description() << '\n';
  const auto agreement = compare_rings(rings, seed);
  print_table(agreement);
  for (const auto& example : agreement.examples) std::cout << example << '\n';
  std::cout << rings << " rings, seed " << seed << ": " << agreement.unexplained
            << " unexplained disagreements\n";
  return agreement.unexplained == 0 ? 0 : 1;
}
