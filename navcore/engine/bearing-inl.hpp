// Private to this folder: reciprocals and bearings, many at a time.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_BEARING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_BEARING_INL
#undef MAPWRIGHT_ENGINE_BEARING_INL
#else
#define MAPWRIGHT_ENGINE_BEARING_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// 1 / x, to 2e-7 relative: an estimate and one step of Newton's, a fraction of a division's time.
// Requires a normal number x with a normal reciprocal.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V reciprocal(D d, V x) {
  const V estimate = hn::ApproximateReciprocal(x);
  return hn::Mul(estimate, hn::NegMulAdd(x, estimate, hn::Set(d, 2.0F)));
}

// atan(t) for t in [0, 1], off by less than 2e-7: a minimax polynomial, absolute error 3.8e-8, and
// rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V arc_tangent(D d, V t) {
  const V s = hn::Mul(t, t);
  V p = hn::Set(d, -0.004054564982652664F);
  p = hn::MulAdd(p, s, hn::Set(d, 0.021862950176000595F));
  p = hn::MulAdd(p, s, hn::Set(d, -0.0559123158454895F));
  p = hn::MulAdd(p, s, hn::Set(d, 0.09642196446657181F));
  p = hn::MulAdd(p, s, hn::Set(d, -0.1390862911939621F));
  p = hn::MulAdd(p, s, hn::Set(d, 0.19946566224098206F));
  p = hn::MulAdd(p, s, hn::Set(d, -0.33329859375953674F));
  p = hn::MulAdd(p, s, hn::Set(d, 0.9999993443489075F));
  return hn::Mul(p, t);
}

// Bearing of the points (x, y) in [−π, π], off by less than 6e-7 rad. Equal coordinates give equal
// bearings, whichever segment the point is an end of. Any number for the origin.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V bearing_of(D d, V x, V y) {
  const V abs_x = hn::Abs(x);
  const V abs_y = hn::Abs(y);
  const V longer = hn::Max(hn::Max(abs_x, abs_y), hn::Set(d, 1e-30F));
  V angle = arc_tangent(d, hn::Mul(hn::Min(abs_x, abs_y), reciprocal(d, longer)));
  angle = hn::IfThenElse(hn::Gt(abs_y, abs_x), hn::Sub(hn::Set(d, 1.57079637F), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 3.14159274F), angle), angle);
  return hn::CopySignToAbs(angle, y);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
