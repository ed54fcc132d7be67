// Private to this folder: casts scans and weighs them in the same pass.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_WEIGH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_WEIGH_INL
#undef MAPWRIGHT_ENGINE_WEIGH_INL
#else
#define MAPWRIGHT_ENGINE_WEIGH_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "navcore/engine/cast-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// exp(x) for x in [−87, 80], relative error below 3e-7; smaller x count as −87 (1.6e-38).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exponential(D d, V x) {
  const hn::RebindToSigned<D> di;
  x = hn::Max(x, hn::Set(d, -87.0F));
  const V k = hn::Round(hn::Mul(x, hn::Set(d, 1.44269504F)));
  // ln 2 in two pieces, so that the remainder is exact enough.
  V r = hn::NegMulAdd(k, hn::Set(d, 0.693359375F), x);
  r = hn::NegMulAdd(k, hn::Set(d, -2.12194440e-4F), r);
  V p = hn::Set(d, 1.0F / 720.0F);
  p = hn::MulAdd(p, r, hn::Set(d, 1.0F / 120.0F));
  p = hn::MulAdd(p, r, hn::Set(d, 1.0F / 24.0F));
  p = hn::MulAdd(p, r, hn::Set(d, 1.0F / 6.0F));
  p = hn::MulAdd(p, r, hn::Set(d, 0.5F));
  p = hn::MulAdd(p, r, hn::Set(d, 1.0F));
  p = hn::MulAdd(p, r, hn::Set(d, 1.0F));
  const auto power = hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, k), hn::Set(di, 127)));
  return hn::Mul(p, hn::BitCast(d, power));
}

// The floor that Eq. (5) has under a beam.
HWY_INLINE FloatVector floor_under(const ScanWeight& weight, FloatVector delta) {
  const Floats d;
  return hn::IfThenElse(hn::Gt(delta, hn::Zero(d)), hn::Set(d, weight.longer_floor),
                        hn::Set(d, weight.shorter_floor));
}

HWY_INLINE FloatVector exponent_of(const ScanWeight& weight, FloatVector delta) {
  return hn::Mul(hn::Mul(delta, delta), hn::Set(Floats(), weight.sharpness));
}

// Δ of Eq. (4) for all beams, into the workspace; pads are 0. Returns the greatest exponent
// Δ² / (2 σm²) of the beams without a floor.
HWY_INLINE float find_differences(const ScanWeight& weight, const BeamTable& beams,
                                  const float* inverse, Workspace& work) {
  const Floats d;
  FloatVector largest = hn::Zero(d);
  for (std::size_t i = 0; i < beams.rays; i += hn::Lanes(d)) {
    const FloatVector difference = hn::Sub(hn::Load(d, weight.perceived.data() + i),
                                           ranges_of(beams, hn::Load(d, inverse + i)));
    const FloatVector delta = hn::IfThenElseZero(hn::FirstN(d, beams.rays - i), difference);
    hn::Store(delta, d, work.differences.data() + i);
    const FloatMask unlimited = hn::Eq(floor_under(weight, delta), hn::Zero(d));
    largest = hn::Max(largest, hn::IfThenElseZero(unlimited, hn::Mul(delta, delta)));
  }
  return weight.sharpness * hn::GetLane(hn::MaxOfLanes(d, largest));
}

// Eq. (6): −log Σ 1/L, summed relative to exp(shift), so that the greatest term stays well within
// single precision whatever the scan.
HWY_INLINE double log_harmonic(const ScanWeight& weight, const BeamTable& beams,
                               const float* inverse, Workspace& work) {
  constexpr float kLargestExponent = 70.0F;
  const Floats d;
  const float shift =
      std::max(0.0F, find_differences(weight, beams, inverse, work) - kLargestExponent);
  const FloatVector shift_by = hn::Set(d, shift);
  const FloatVector scale = exponential(d, hn::Neg(shift_by));
  const FloatVector peak = hn::Set(d, weight.peak);
  const FloatVector per_peak = hn::Set(d, 1.0F / weight.peak);
  FloatVector sum = hn::Zero(d);
  for (std::size_t i = 0; i < beams.rays; i += hn::Lanes(d)) {
    const FloatVector delta = hn::Load(d, work.differences.data() + i);
    const FloatVector floor = floor_under(weight, delta);
    const FloatMask unlimited = hn::Eq(floor, hn::Zero(d));
    const FloatVector exponent = exponent_of(weight, delta);
    const FloatVector e =
        exponential(d, hn::IfThenElse(unlimited, hn::Sub(exponent, shift_by), hn::Neg(exponent)));
    const FloatVector limited = hn::Mul(scale, reciprocal(d, hn::MulAdd(peak, e, floor)));
    const FloatVector term = hn::IfThenElse(unlimited, hn::Mul(e, per_peak), limited);
    sum = hn::Add(sum, hn::IfThenElseZero(hn::FirstN(d, beams.rays - i), term));
  }
  return -std::log(static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)))) -
         static_cast<double>(shift);
}

// Σ log L. Beams with a floor are multiplied, as many as single precision allows before a
// logarithm is taken; of those without one the exponent is the logarithm.
HWY_INLINE double log_product(const ScanWeight& weight, const BeamTable& beams,
                              const float* inverse) {
  const Floats d;
  const FloatVector peak = hn::Set(d, weight.peak);
  const FloatVector one = hn::Set(d, 1.0F);
  FloatVector sum = hn::Zero(d);
  FloatVector product = one;
  std::size_t factors = 0;
  for (std::size_t i = 0; i < beams.rays; i += hn::Lanes(d)) {
    const FloatVector delta = hn::Sub(hn::Load(d, weight.perceived.data() + i),
                                      ranges_of(beams, hn::Load(d, inverse + i)));
    const FloatVector floor = floor_under(weight, delta);
    const FloatMask unlimited = hn::Eq(floor, hn::Zero(d));
    const FloatMask real = hn::FirstN(d, beams.rays - i);
    const FloatVector exponent = exponent_of(weight, delta);
    const FloatVector gauss = hn::Mul(peak, exponential(d, hn::Neg(exponent)));
    const FloatVector factor = hn::IfThenElse(unlimited, peak, hn::Add(gauss, floor));
    product = hn::Mul(product, hn::IfThenElse(real, factor, one));
    sum = hn::Sub(sum, hn::IfThenElseZero(hn::And(real, unlimited), exponent));
    if (++factors == weight.safe_factors) {
      sum = hn::Add(sum, hn::Log(d, product));
      product = one;
      factors = 0;
    }
  }
  sum = hn::Add(sum, hn::Log(d, product));
  return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
}

void weigh_scans(const ScanSetup& setup, const ScanStarts& starts, Workspace& work,
                 const ScanWeight& weight, double* log_weights) {
  const BeamTable& beams = *setup.beams;
  for_each_scan(setup, starts, work, [&](std::uint32_t scan, const float* inverse) HWY_ATTR {
    log_weights[scan] = weight.kind == LikelihoodKind::kReport
                            ? log_harmonic(weight, beams, inverse, work)
                            : log_product(weight, beams, inverse);
  });
}

void turn_headings(std::span<const double> headings, double* cosines, double* sines) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= headings.size(); i += lanes) {
    const auto heading = hn::LoadU(d, headings.data() + i);
    hn::StoreU(hn::Cos(d, heading), d, cosines + i);
    hn::StoreU(hn::Sin(d, heading), d, sines + i);
  }
  for (; i < headings.size(); ++i) {
    cosines[i] = std::cos(headings[i]);
    sines[i] = std::sin(headings[i]);
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
