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

#include <cmath>
#include <numbers>

#include "navcore/engine/cast-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// 2^x for x in [−126, 127), relative error below 3e-7, as power · fraction. Adding `magic` rounds x
// to a whole number and leaves that number, biased as exponents are, in the lowest bits.
struct PowerOfTwo {
  HWY_INLINE explicit PowerOfTwo(FloatVector x) {
    const Floats d;
    const FloatVector magic = hn::Set(d, 12582912.0F + 127.0F);
    const FloatVector biased = hn::Add(x, magic);
    const FloatVector r = hn::Sub(x, hn::Sub(biased, magic));
    power = hn::BitCast(d, hn::ShiftLeft<23>(hn::BitCast(Ints(), biased)));
    // A minimax polynomial of 2^r in [−½, ½].
    FloatVector p = hn::Set(d, 0.0013276472454890609F);
    p = hn::MulAdd(p, r, hn::Set(d, 0.009675540961325169F));
    p = hn::MulAdd(p, r, hn::Set(d, 0.05550713092088699F));
    p = hn::MulAdd(p, r, hn::Set(d, 0.24022120237350464F));
    p = hn::MulAdd(p, r, hn::Set(d, 0.6931469440460205F));
    fraction = hn::MulAdd(p, r, hn::Set(d, 1.0F));
  }

  FloatVector power, fraction;
};

// Likelihoods stay between these powers of two: they have reciprocals, of which many can be added.
constexpr float kLeastPower = -126.0F;
constexpr float kMostPower = 100.0F;

// Δ of Eq. (4).
HWY_INLINE FloatVector difference(const ScanWeight& weight, const BeamTable& beams,
                                  const float* inverse, std::size_t i) {
  const Floats d;
  return hn::Sub(hn::Load(d, weight.perceived.data() + i),
                 ranges_of(beams, hn::Load(d, inverse + i)));
}

// Calls f(i, which lanes are rays) for the vectors of a scan.
template <class F>
HWY_INLINE void for_each_vector(const BeamTable& beams, F&& f) {
  const Floats d;
  const FloatMask all = hn::FirstN(d, hn::Lanes(d));
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= beams.rays; i += hn::Lanes(d)) f(i, all);
  if (i < beams.rays) f(i, hn::FirstN(d, beams.rays - i));
}

// -- Eq. (6) -----------------------------------------------------------------------------------

// One number for each of the scans cast together.
struct EachScan {
  alignas(kLine) float of[kBlock] = {};
};

// Turns inverse ranges into steepness Δ²: positive for beams without a floor, negative (or 0) for
// the others. Returns the greatest, or 0.
HWY_INLINE float find_exponents(const ScanWeight& weight, const BeamTable& beams, float* row) {
  const Floats d;
  const FloatVector steepness = hn::Set(d, weight.steepness);
  // Without β no beam has a floor.
  const FloatVector drop = weight.shorter_floor > 0.0F ? hn::Zero(d) : hn::SignBit(d);
  FloatVector largest = hn::Zero(d);
  for_each_vector(beams, [&](std::size_t i, FloatMask rays) MAPWRIGHT_INLINE_LAMBDA {
    const FloatVector delta = difference(weight, beams, row, i);
    const FloatVector exponent =
        hn::AndNot(drop, hn::Mul(hn::Mul(delta, steepness), hn::Abs(delta)));
    hn::Store(exponent, d, row + i);
    largest = hn::Max(largest, hn::IfThenElseZero(rays, exponent));
  });
  return hn::GetLane(hn::MaxOfLanes(d, largest));
}

// Σ 1/(L 2^shift) of a row of exponents, given log2_peak + shift and floor · 2^shift.
HWY_INLINE float sum_of_inverses(const BeamTable& beams, const float* row, float raised_peak,
                                 float raised_floor) {
  const Floats d;
  const FloatVector peak = hn::Set(d, raised_peak);
  const FloatVector floor = hn::Set(d, raised_floor);
  const FloatVector least = hn::Set(d, kLeastPower), most = hn::Set(d, kMostPower);
  FloatVector sum = hn::Zero(d);
  for_each_vector(beams, [&](std::size_t i, FloatMask rays) MAPWRIGHT_INLINE_LAMBDA {
    const FloatVector exponent = hn::Load(d, row + i);
    const FloatMask limited = hn::Le(exponent, hn::Zero(d));
    const FloatVector x = hn::Sub(peak, hn::Abs(exponent));
    const PowerOfTwo two(hn::Min(hn::Max(x, least), most));
    const FloatVector likelihood =
        hn::MulAdd(two.power, two.fraction, hn::IfThenElseZero(limited, floor));
    sum = hn::Add(sum, hn::IfThenElseZero(rays, reciprocal(d, likelihood)));
  });
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

// The shifts that keep the greatest term of each scan well within single precision, whole numbers.
HWY_INLINE EachScan shifts_for(const ScanWeight& weight, const EachScan& largest,
                               EachScan& raised_floor) {
  const Floats d;
  EachScan shifts;
  for (std::size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
    const FloatVector excess =
        hn::Sub(hn::Load(d, largest.of + i), hn::Set(d, weight.log2_peak + kMostPower));
    const FloatVector shift = hn::Ceil(hn::Max(excess, hn::Zero(d)));
    // Beyond kMostPower terms of beams with a floor are too small to count.
    const PowerOfTwo raise(hn::Min(shift, hn::Set(d, kMostPower)));
    const FloatVector floor = hn::Mul(hn::Set(d, weight.shorter_floor), raise.power);
    hn::Store(shift, d, shifts.of + i);
    hn::Store(hn::Min(floor, hn::Set(d, 1e36F)), d, raised_floor.of + i);
  }
  return shifts;
}

// Natural logarithms in double precision.
HWY_INLINE void take_logarithms(const EachScan& values, std::size_t count, double* logarithms) {
  const hn::Repartition<double, Floats> dd;
  const hn::Rebind<float, decltype(dd)> df;
  for (std::size_t i = 0; i < count; i += hn::Lanes(dd)) {
    const auto value = hn::PromoteTo(dd, hn::Load(df, values.of + i));
    hn::Store(hn::Log(dd, value), dd, logarithms + i);
  }
}

// −log Σ 1/L of scans cast together. Each stage is done for all scans before the next one begins:
// what a stage waits for in one scan, the processor fills with the others.
void log_harmonic(const ScanWeight& weight, const BeamTable& beams, std::size_t count,
                  Workspace& work, double* logarithms) {
  EachScan largest, raised_floor, sums;
  for (std::size_t i = 0; i < count; ++i) {
    largest.of[i] = find_exponents(weight, beams, work.inverse(i));
  }
  const EachScan shifts = shifts_for(weight, largest, raised_floor);
  for (std::size_t i = 0; i < count; ++i) {
    sums.of[i] = sum_of_inverses(beams, work.inverse(i), weight.log2_peak + shifts.of[i],
                                 raised_floor.of[i]);
  }
  take_logarithms(sums, count, logarithms);
  for (std::size_t i = 0; i < count; ++i) {
    logarithms[i] = -logarithms[i] - std::numbers::ln2 * static_cast<double>(shifts.of[i]);
  }
}

// -- the robust likelihood ---------------------------------------------------------------------

// Σ log L. Beams with a floor are multiplied, as many as single precision allows before a
// logarithm is taken; of those without one the exponent is the logarithm.
template <bool kAllHaveFloors>
HWY_INLINE double log_product(const ScanWeight& weight, const BeamTable& beams,
                              const float* inverse) {
  const Floats d;
  const FloatVector peak = hn::Set(d, weight.peak), log2_peak = hn::Set(d, weight.log2_peak);
  const FloatVector longer = hn::Set(d, weight.longer_floor);
  const FloatVector shorter = hn::Set(d, weight.shorter_floor);
  const FloatVector steepness = hn::Set(d, weight.steepness);
  const FloatVector one = hn::Set(d, 1.0F);
  FloatVector sum = hn::Zero(d), exponents = hn::Zero(d), product = one;
  std::size_t factors = 0;
  for_each_vector(beams, [&](std::size_t i, FloatMask rays) MAPWRIGHT_INLINE_LAMBDA {
    const FloatVector delta = difference(weight, beams, inverse, i);
    const FloatVector floor = hn::IfThenElse(hn::Gt(delta, hn::Zero(d)), longer, shorter);
    const FloatVector exponent = hn::Mul(hn::Mul(delta, steepness), delta);
    const PowerOfTwo two(hn::Max(hn::Sub(log2_peak, exponent), hn::Set(d, kLeastPower)));
    FloatVector factor = hn::MulAdd(two.power, two.fraction, floor);
    if constexpr (!kAllHaveFloors) {
      const FloatMask unlimited = hn::Eq(floor, hn::Zero(d));
      factor = hn::IfThenElse(unlimited, peak, factor);
      exponents = hn::Add(exponents, hn::IfThenElseZero(hn::And(rays, unlimited), exponent));
    }
    product = hn::Mul(product, hn::IfThenElse(rays, factor, one));
    if (++factors == weight.safe_factors) {
      sum = hn::Add(sum, hn::Log(d, product));
      product = one;
      factors = 0;
    }
  });
  sum = hn::Add(sum, hn::Log(d, product));
  sum = hn::NegMulAdd(exponents, hn::Set(d, std::numbers::ln2_v<float>), sum);
  return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
}

void log_products(const ScanWeight& weight, const BeamTable& beams, std::size_t count,
                  Workspace& work, double* logarithms) {
  const bool all_have_floors = weight.shorter_floor > 0.0F && weight.longer_floor > 0.0F;
  for (std::size_t i = 0; i < count; ++i) {
    logarithms[i] = all_have_floors ? log_product<true>(weight, beams, work.inverse(i))
                                    : log_product<false>(weight, beams, work.inverse(i));
  }
}

// -- scans -------------------------------------------------------------------------------------

void weigh_scans(const ScanSetup& setup, const ScanStarts& starts, Workspace& work,
                 const ScanWeight& weight, double* log_weights) {
  const auto weigh = weight.kind == LikelihoodKind::kReport ? log_harmonic : log_products;
  cast_together(setup, starts, work, [&](ScansTogether scans) HWY_ATTR {
    alignas(kLine) double logarithms[kBlock];
    weigh(weight, *setup.beams, scans.size(), work, logarithms);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      log_weights[starts.scan[scans[i].start]] = logarithms[i];
    }
  });
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
