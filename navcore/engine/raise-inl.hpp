// Private to this folder: raises inverse ranges to what spans say.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_RAISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_RAISE_INL
#undef MAPWRIGHT_ENGINE_RAISE_INL
#else
#define MAPWRIGHT_ENGINE_RAISE_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "navcore/engine/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// What becomes of rays that meet a segment at inverse ranges `value`: it stops them,
struct Stop {
  HWY_INLINE FloatVector operator()(FloatVector old, FloatMask met, FloatVector value) const {
    return hn::Max(old, hn::IfThenElseZero(met, value));
  }
};

// or where they meet it first, they go on as if nothing stood behind it.
struct Cross {
  HWY_INLINE FloatVector operator()(FloatVector old, FloatMask met, FloatVector value) const {
    const FloatMask crossed = hn::And(met, hn::Gt(value, old));
    return hn::IfThenElse(crossed, hn::Set(Floats(), out_of_range), old);
  }

  float out_of_range;
};

/// The arrays that raising reads and writes. Copies of pointers tell the compiler that no store
/// changes them.
template <class Meet>
class Raise {
 public:
  HWY_INLINE Raise(const BeamTable& beams, const SpanList& spans, float* HWY_RESTRICT buffers,
                   Meet meet)
      : meet_(meet),
        cosine_(beams.cosine.data()),
        sine_(beams.sine.data()),
        number_(beams.number.data()),
        spans_(reinterpret_cast<const float*>(spans.blocks.data())),
        buffers_(buffers) {}

  // The first rays of a span.
  HWY_INLINE void begin(std::int32_t lane) const { raise_first<0>(lane); }

  // As many more, of a span that has some of them.
  HWY_INLINE void go_on(std::int32_t lane) const { raise_first<kFirstRays>(lane); }

  // The rest, two vectors at a time: rows are one block longer than the rays.
  HWY_INLINE void complete(std::int32_t lane) const {
    const Span span = span_at(lane);
    const std::int32_t end = integer(lane, offsetof(SpanBlock, end));
    for (std::int32_t skip = kAtOnce; span.ray + skip < end; skip += 2 * kStep) {
      raise_before(end, span, skip);
      raise_before(end, span, skip + kStep);
    }
  }

 private:
  struct Span {
    FloatVector cosine, sine;
    std::int32_t ray, at;
  };

  HWY_INLINE const float* number_at(std::int32_t lane, std::size_t member) const {
    return spans_ + lane + member / sizeof(float);
  }
  HWY_INLINE std::int32_t integer(std::int32_t lane, std::size_t member) const {
    std::int32_t value;
    std::memcpy(&value, number_at(lane, member), sizeof(value));
    return value;
  }
  HWY_INLINE Span span_at(std::int32_t lane) const {
    const Floats d;
    return {hn::Set(d, *number_at(lane, offsetof(SpanBlock, cosine))),
            hn::Set(d, *number_at(lane, offsetof(SpanBlock, sine))),
            integer(lane, offsetof(SpanBlock, ray)), integer(lane, offsetof(SpanBlock, at))};
  }

  template <std::int32_t kSkip>
  HWY_INLINE void raise_first(std::int32_t lane) const {
    const Span span = span_at(lane);
#if HWY_TARGET <= HWY_AVX3
    const auto* const bits =
        reinterpret_cast<const std::uint8_t*>(number_at(lane, offsetof(SpanBlock, which)));
    raise(span, hn::LoadMaskBits(Floats(), bits + kSkip / 8), span.ray + kSkip, span.at + kSkip);
#else
    const IntVector first = hn::Set(Ints(), integer(lane, offsetof(SpanBlock, which)));
    const IntVector end = hn::Set(Ints(), integer(lane, offsetof(SpanBlock, end)));
    for (std::int32_t skip = kSkip; skip < kSkip + kFirstRays; skip += kStep) {
      const IntVector number = hn::Load(Ints(), number_ + span.ray + skip);
      const auto met = hn::AndNot(hn::Gt(first, number), hn::Gt(end, number));
      raise(span, hn::RebindMask(Floats(), met), span.ray + skip, span.at + skip);
    }
#endif
  }

  // A vector of rays, of which those before `end` belong to the span.
  HWY_INLINE void raise_before(std::int32_t end, const Span& span, std::int32_t skip) const {
    const auto met = hn::Gt(hn::Set(Ints(), end), hn::Load(Ints(), number_ + span.ray + skip));
    raise(span, hn::RebindMask(Floats(), met), span.ray + skip, span.at + skip);
  }

  // A vector of rays.
  HWY_INLINE void raise(const Span& span, FloatMask met, std::int32_t ray, std::int32_t at) const {
    const Floats d;
    const FloatVector value = hn::MulAdd(span.cosine, hn::Load(d, cosine_ + ray),
                                         hn::Mul(span.sine, hn::Load(d, sine_ + ray)));
    const FloatVector old = hn::Load(d, buffers_ + at);
    hn::Store(meet_(old, met, value), d, buffers_ + at);
  }

  Meet meet_;
  const float* HWY_RESTRICT cosine_;
  const float* HWY_RESTRICT sine_;
  const std::int32_t* HWY_RESTRICT number_;
  const float* HWY_RESTRICT spans_;
  float* HWY_RESTRICT buffers_;
};

// Raises the buffers to what the spans say, in rounds: the first rays of all spans, then more of
// those that have more. How many rays a span has is a coin that branch prediction loses.
template <class Meet = Stop>
HWY_INLINE void raise_spans(const BeamTable& beams, const SpanList& spans, float* buffers,
                            Meet meet = {}) {
  if (spans.lanes == 0) return;
  const Raise raise(beams, spans, buffers, meet);
  const auto for_lanes = [](const LaneList& list, auto&& f) MAPWRIGHT_INLINE_LAMBDA {
    const std::int32_t* HWY_RESTRICT const lanes = list.lanes.data();
    const std::size_t size = list.size;
    for (std::size_t i = 0; i < size; ++i) f(lanes[i]);
  };
  for_lanes(spans.seen, [&](std::int32_t i) MAPWRIGHT_INLINE_LAMBDA { raise.begin(i); });
  for_lanes(spans.longer, [&](std::int32_t i) MAPWRIGHT_INLINE_LAMBDA { raise.go_on(i); });
  for_lanes(spans.longest, [&](std::int32_t i) MAPWRIGHT_INLINE_LAMBDA { raise.complete(i); });
}

HWY_INLINE void fill(float* array, std::size_t size, float value) {
  const Floats d;
  const FloatVector v = hn::Set(d, value);
  for (std::size_t i = 0; i < size; i += hn::Lanes(d)) hn::Store(v, d, array + i);
}

// Nothing stops the rays of a scan. What lies behind the last block with rays is never read.
HWY_INLINE void clear_inverse(const BeamTable& beams, float* inverse) {
  fill(inverse, beams.padded_rays() - kBlock, beams.out_of_range);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
