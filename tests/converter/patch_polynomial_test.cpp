// The polynomial of a patch against plain arithmetic, by every instruction set of this machine.
#include "converter/frame/patch_polynomial.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <vector>

#include "mapcore/random.hpp"

namespace mapwright::converter {
namespace {

using Polynomials = std::array<double, PatchPolynomial::kNodes>;

Polynomials chebyshev(double t) {
  const double t2 = 2.0 * t * t - 1.0;
  const double t3 = 2.0 * t * t2 - t;
  return {1.0, t, t2, t3, 2.0 * t * t3 - t2};
}

Point plainly(const PatchPolynomial& p, Point at) {
  const auto across = chebyshev((at.x - p.center.x) * p.inverse_half);
  const auto up = chebyshev((at.y - p.center.y) * p.inverse_half);
  Point sum;
  std::size_t next = 0;
  for (std::size_t m = 0; m < PatchPolynomial::kNodes; ++m) {
    Point row;
    for (std::size_t n = 0; m + n < PatchPolynomial::kNodes; ++n, ++next) {
      row.x += p.coefficients[next].x * up[n];
      row.y += p.coefficients[next].y * up[n];
    }
    sum.x += row.x * across[m];
    sum.y += row.y * across[m];
  }
  return sum;
}

PatchPolynomial random_polynomial(Random& random) {
  PatchPolynomial p;
  p.center = {random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6)};
  p.inverse_half = 1.0 / 4096.0;
  for (auto& c : p.coefficients) c = {random.uniform(-9e3, 9e3), random.uniform(-9e3, 9e3)};
  return p;
}

// Bit by bit; what lies beside the points stays as it was.
void expect_plain_arithmetic() {
  Random random(8);
  for (std::size_t count = 0; count < 40; ++count) {
    const auto p = random_polynomial(random);
    std::vector<double> xs(count + 2), ys(count + 2);
    for (auto& x : xs) x = p.center.x + random.uniform(-4096.0, 4096.0);
    for (auto& y : ys) y = p.center.y + random.uniform(-4096.0, 4096.0);
    auto expected_xs = xs, expected_ys = ys;
    for (std::size_t i = 1; i <= count; ++i) {
      const Point image = plainly(p, {xs[i], ys[i]});
      expected_xs[i] = image.x;
      expected_ys[i] = image.y;
    }
    p.apply(&xs[1], &ys[1], count);
    ASSERT_EQ(xs, expected_xs) << count;
    ASSERT_EQ(ys, expected_ys) << count;
  }
}

TEST(PatchPolynomial, IsPlainArithmeticOnEveryInstructionSet) {
  for (auto targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    const auto target = targets & -targets;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    SCOPED_TRACE(hwy::TargetName(target));
    expect_plain_arithmetic();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace
}  // namespace mapwright::converter
