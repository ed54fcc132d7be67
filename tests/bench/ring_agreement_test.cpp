#include "bench/support/ring_agreement.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace mapwright::bench {
namespace {

TEST(RingValidity, AgreesWithGeosAndCgalOnRandomRings) {
  const auto agreement = compare_rings(20'000, 2);
  EXPECT_EQ(agreement.unexplained, 0U)
      << (agreement.examples.empty() ? "" : agreement.examples.front());
}

// A generator of which all rings were valid, or none, would prove nothing.
TEST(RingValidity, IsAskedAboutRingsOfBothKinds) {
  const auto agreement = compare_rings(8'000, 3);
  for (std::size_t kind = 0; kind < kRingKinds; ++kind) {
    const auto& row = agreement.counts[kind];
    EXPECT_EQ(std::accumulate(row.begin(), row.end(), std::uint64_t{0}), 8'000 / kRingKinds);
    EXPECT_GT(row[1] + row[2], 50U) << to_string(static_cast<RingKind>(kind));
  }
  std::uint64_t valid = 0;
  for (const auto& row : agreement.counts) valid += row[0];
  EXPECT_GT(valid, 1'000U);
}

}  // namespace
}  // namespace mapwright::bench
