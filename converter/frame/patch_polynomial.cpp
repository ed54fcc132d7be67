// Compiled once for each instruction set (Highway).
#include "converter/frame/patch_polynomial.hpp"

// Highway switches its 128-bit baseline off for this compiler because of a bug in multiplications
// of integers (GCC 106322). None are multiplied here.
#define HWY_BROKEN_EMU128 0
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "converter/frame/patch_polynomial.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mapwright::converter::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Lanes = hn::Vec<Doubles>;

// T1 to T4 at each lane's place; T0 is 1. Products and sums stay apart, as fusing them would round
// otherwise on processors that can.
struct Polynomials {
  HWY_INLINE Polynomials(Lanes at, double middle, double inverse_half) {
    const Doubles d;
    t1 = hn::Mul(hn::Sub(at, hn::Set(d, middle)), hn::Set(d, inverse_half));
    const auto twice = hn::Add(t1, t1);
    t2 = hn::Sub(hn::Mul(twice, t1), hn::Set(d, 1.0));
    t3 = hn::Sub(hn::Mul(twice, t2), t1);
    t4 = hn::Sub(hn::Mul(twice, t3), t2);
  }
  Lanes t1, t2, t3, t4;
};

struct Row {
  Lanes x, y;

  HWY_INLINE explicit Row(const PatchPolynomial::Coefficient& first)
      : x(hn::Set(Doubles(), first.x)), y(hn::Set(Doubles(), first.y)) {}
  HWY_INLINE void add(const PatchPolynomial::Coefficient& c, Lanes t) {
    x = hn::Add(x, hn::Mul(hn::Set(Doubles(), c.x), t));
    y = hn::Add(y, hn::Mul(hn::Set(Doubles(), c.y), t));
  }
  HWY_INLINE void add(const Row& row, Lanes t) {
    x = hn::Add(x, hn::Mul(row.x, t));
    y = hn::Add(y, hn::Mul(row.y, t));
  }
};

HWY_INLINE void apply_lanes(const PatchPolynomial& p, Lanes& x, Lanes& y) {
  const Polynomials across(x, p.center.x, p.inverse_half), up(y, p.center.y, p.inverse_half);
  const auto& c = p.coefficients;
  Row sum(c[0]);
  sum.add(c[1], up.t1);
  sum.add(c[2], up.t2);
  sum.add(c[3], up.t3);
  sum.add(c[4], up.t4);
  Row row1(c[5]);
  row1.add(c[6], up.t1);
  row1.add(c[7], up.t2);
  row1.add(c[8], up.t3);
  Row row2(c[9]);
  row2.add(c[10], up.t1);
  row2.add(c[11], up.t2);
  Row row3(c[12]);
  row3.add(c[13], up.t1);
  sum.add(row1, across.t1);
  sum.add(row2, across.t2);
  sum.add(row3, across.t3);
  sum.add(Row(c[14]), across.t4);
  x = sum.x;
  y = sum.y;
}

// Fewer points than there are lanes.
HWY_INLINE void apply_rest(const PatchPolynomial& p, double* xs, double* ys, std::size_t count) {
  const Doubles d;
#if HWY_TARGET <= HWY_AVX3
  const auto used = hn::FirstN(d, count);
  auto x = hn::MaskedLoad(used, d, xs), y = hn::MaskedLoad(used, d, ys);
  apply_lanes(p, x, y);
  hn::BlendedStore(x, used, d, xs);
  hn::BlendedStore(y, used, d, ys);
#else
  HWY_ALIGN double rest_x[8] = {}, rest_y[8] = {};
  std::copy_n(xs, count, rest_x);
  std::copy_n(ys, count, rest_y);
  auto x = hn::Load(d, rest_x), y = hn::Load(d, rest_y);
  apply_lanes(p, x, y);
  hn::Store(x, d, rest_x);
  hn::Store(y, d, rest_y);
  std::copy_n(rest_x, count, xs);
  std::copy_n(rest_y, count, ys);
#endif
}

void apply_patch(const PatchPolynomial& p, double* xs, double* ys, std::size_t count) {
  const Doubles d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    auto x = hn::LoadU(d, xs + i), y = hn::LoadU(d, ys + i);
    apply_lanes(p, x, y);
    hn::StoreU(x, d, xs + i);
    hn::StoreU(y, d, ys + i);
  }
  if (i < count) apply_rest(p, xs + i, ys + i, count - i);
}

}  // namespace mapwright::converter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mapwright::converter {

HWY_EXPORT(apply_patch);

void PatchPolynomial::apply(double* xs, double* ys, std::size_t count) const {
  HWY_DYNAMIC_DISPATCH(apply_patch)(*this, xs, ys, count);
}

}  // namespace mapwright::converter
#endif
