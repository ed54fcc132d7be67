// Private to this folder: raises inverse ranges to what spans say.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_RAISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_RAISE_INL
#undef MAPWRIGHT_ENGINE_RAISE_INL
#else
#define MAPWRIGHT_ENGINE_RAISE_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

#include "navcore/engine/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Rays that are done without asking whether a span has so many: most have not, and how
// many is a coin that branch prediction loses. For that, rows are one block longer than the rays.
constexpr std::int32_t kStep = static_cast<std::int32_t>(hn::MaxLanes(Floats()));
constexpr std::int32_t kAtOnce = kStep * (kStep == 16 ? 2 : kStep == 8 ? 3 : 4);

/// The arrays that raising reads and writes. Copies of pointers tell the compiler that no store
/// changes them.
class Raise {
 public:
  HWY_INLINE Raise(const BeamTable& beams, const SpanList& spans, float* HWY_RESTRICT buffers)
      : cosine_(beams.cosine.data()),
        sine_(beams.sine.data()),
        number_(beams.number.data()),
        span_cosine_(spans.cosine.data()),
        span_sine_(spans.sine.data()),
        ray_(spans.ray.data()),
        which_(spans.which.data()),
        end_(spans.end.data()),
        at_(spans.at.data()),
        buffers_(buffers) {}

  // The first rays of a span.
  HWY_INLINE void begin(std::size_t i) const {
    const FloatVector cosine = hn::Set(Floats(), span_cosine_[i]);
    const FloatVector sine = hn::Set(Floats(), span_sine_[i]);
    const std::int32_t ray = ray_[i];
    const std::int32_t at = at_[i];
#if HWY_TARGET <= HWY_AVX3
    const auto* const bits = reinterpret_cast<const std::uint8_t*>(which_ + i);
    raise(cosine, sine, hn::LoadMaskBits(Floats(), bits), ray, at);
    raise(cosine, sine, hn::LoadMaskBits(Floats(), bits + 2), ray + kStep, at + kStep);
#else
    const IntVector first = hn::Set(Ints(), which_[i]);
    const IntVector end = hn::Set(Ints(), end_[i]);
    for (std::int32_t skip = 0; skip < kAtOnce; skip += kStep) {
      const IntVector number = hn::Load(Ints(), number_ + ray + skip);
      const auto met = hn::AndNot(hn::Gt(first, number), hn::Gt(end, number));
      raise(cosine, sine, hn::RebindMask(Floats(), met), ray + skip, at + skip);
    }
#endif
  }

  HWY_INLINE bool has_more(std::size_t i) const {
    return end_[i] - ray_[i] > kAtOnce;
  }

  // The other rays of a span.
  HWY_INLINE void complete(std::size_t i) const {
    const FloatVector cosine = hn::Set(Floats(), span_cosine_[i]);
    const FloatVector sine = hn::Set(Floats(), span_sine_[i]);
    const IntVector end = hn::Set(Ints(), end_[i]);
    const std::int32_t rays = end_[i] - ray_[i];
    for (std::int32_t skip = kAtOnce; skip < rays; skip += kStep) {
      const auto met = hn::Gt(end, hn::Load(Ints(), number_ + ray_[i] + skip));
      raise(cosine, sine, hn::RebindMask(Floats(), met), ray_[i] + skip, at_[i] + skip);
    }
  }

 private:
  // A vector of rays.
  HWY_INLINE void raise(FloatVector cosine, FloatVector sine, FloatMask met, std::int32_t ray,
                        std::int32_t at) const {
    const Floats d;
    const FloatVector value =
        hn::MulAdd(cosine, hn::Load(d, cosine_ + ray), hn::Mul(sine, hn::Load(d, sine_ + ray)));
    const FloatVector old = hn::Load(d, buffers_ + at);
    hn::Store(hn::Max(old, hn::IfThenElseZero(met, value)), d, buffers_ + at);
  }

  const float* HWY_RESTRICT cosine_;
  const float* HWY_RESTRICT sine_;
  const std::int32_t* HWY_RESTRICT number_;
  const float* HWY_RESTRICT span_cosine_;
  const float* HWY_RESTRICT span_sine_;
  const std::int32_t* HWY_RESTRICT ray_;
  const std::int32_t* HWY_RESTRICT which_;
  const std::int32_t* HWY_RESTRICT end_;
  const std::int32_t* HWY_RESTRICT at_;
  float* HWY_RESTRICT buffers_;
};

// Raises the buffers to what the spans say; long spans in a second turn.
HWY_INLINE void raise_spans(const BeamTable& beams, SpanList& spans, float* buffers) {
  const Raise raise(beams, spans, buffers);
  const std::int32_t* HWY_RESTRICT const seen = spans.seen.data();
  std::int32_t* HWY_RESTRICT const longer = spans.longer.data();
  const std::size_t size = spans.size;
  std::size_t left = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t lane = kListsAreDense ? i : static_cast<std::size_t>(seen[i]);
    raise.begin(lane);
    longer[left] = static_cast<std::int32_t>(lane);
    left += raise.has_more(lane) ? 1 : 0;
  }
  for (std::size_t i = 0; i < left; ++i) raise.complete(static_cast<std::size_t>(longer[i]));
}

HWY_INLINE void fill(float* array, std::size_t size, float value) {
  const Floats d;
  const FloatVector v = hn::Set(d, value);
  for (std::size_t i = 0; i < size; i += hn::Lanes(d)) hn::Store(v, d, array + i);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
