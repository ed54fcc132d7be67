// Private to this folder: lists spans of rays.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_SPANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_SPANS_INL
#undef MAPWRIGHT_ENGINE_SPANS_INL
#else
#define MAPWRIGHT_ENGINE_SPANS_INL
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "navcore/engine/packing-inl.hpp"
#include "navcore/engine/span_list.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Rays in a vector, and how many are done first, and at once, without a question to the single
// span.
constexpr std::int32_t kStep = static_cast<std::int32_t>(hn::MaxLanes(Floats()));
constexpr std::int32_t kFirstRays = kStep * (kStep == 16 ? 1 : 2);
constexpr std::int32_t kAtOnce = 2 * kFirstRays;

// The number of the first ray that is not to the right of the bearing, as a whole float plus 2²³,
// whose lowest bits are that number. Ends that segments share give the same number for both, and
// so no ray is between them.
constexpr float kWhole = 8388608.0F;
constexpr std::int32_t kWholeNumber = (1 << 23) - 1;

HWY_INLINE FloatVector ray_at(FloatVector bearing, FloatVector least, FloatVector most,
                              const BeamTable& beams) {
  const Floats d;
  const FloatVector ray =
      hn::MulAdd(bearing, hn::Set(d, beams.rays_per_radian), hn::Set(d, beams.half_past_middle));
  return hn::Add(hn::Min(hn::Max(ray, least), most), hn::Set(d, kWhole));
}

// Which rays a span has, for Raise: bits of the first two vectors, or the first ray.
HWY_INLINE IntVector which_rays(IntVector first, IntVector end, IntVector ray) {
#if HWY_TARGET <= HWY_AVX3
  const IntVector all = hn::Set(Ints(), -1);
  return hn::AndNot(hn::Shl(all, hn::Sub(end, ray)), hn::Shl(all, hn::Sub(first, ray)));
#else
  (void)end;
  (void)ray;
  return first;
#endif
}

HWY_INLINE void append(FloatMask mask, std::size_t first_lane, LaneList& list) {
  const Ints di;
  const ChosenLanes chosen(mask);
  const auto first = static_cast<std::int32_t>(span_lane(first_lane));
  hn::StoreU(hn::Add(chosen.numbers(), hn::Set(di, first)), di, list.lanes.data() + list.size);
  list.size += chosen.count();
}

// Appends those of the lanes' spans from … to that are `valid` and have rays. `row` is where the
// lanes' buffers are. Requires room.
HWY_INLINE void append_spans(const LaneSpans& lanes, FloatVector from, FloatVector to,
                             FloatMask valid, IntVector row, const BeamTable& beams,
                             SpanList& list) {
  const Floats d;
  const Ints di;
  const FloatVector none = hn::Zero(d);
  const FloatVector rays = hn::Set(d, static_cast<float>(beams.rays));
  const FloatVector whole_first = ray_at(from, none, rays, beams);
  const FloatVector whole_end = ray_at(to, none, rays, beams);
  const FloatMask seen = hn::And(valid, hn::Lt(whole_first, whole_end));
  const IntVector number = hn::Set(di, kWholeNumber);
  const IntVector first = hn::And(hn::BitCast(di, whole_first), number);
  const IntVector end = hn::And(hn::BitCast(di, whole_end), number);
  const IntVector ray = hn::And(first, hn::Set(di, -kStep));
  SpanBlock& block = list.blocks[list.lanes / kBlock];
  const std::size_t i = list.lanes % kBlock;
  hn::Store(lanes.cosine, d, block.cosine + i);
  hn::Store(lanes.sine, d, block.sine + i);
  hn::Store(ray, di, block.ray + i);
  hn::Store(which_rays(first, end, ray), di, block.which + i);
  hn::Store(end, di, block.end + i);
  hn::Store(hn::Add(ray, row), di, block.at + i);
  const auto longer_than = [&](std::int32_t most) MAPWRIGHT_INLINE_LAMBDA {
    return hn::And(seen, hn::RebindMask(d, hn::Gt(hn::Sub(end, ray), hn::Set(di, most))));
  };
  append(seen, list.lanes, list.seen);
  append(longer_than(kFirstRays), list.lanes, list.longer);
  append(longer_than(kAtOnce), list.lanes, list.longest);
  list.lanes += hn::Lanes(d);
}

// Appends the lanes' spans; those that are seen at both ends of the field of view, around the back,
// twice. Requires room.
HWY_INLINE void append_spans(const LaneSpans& lanes, FloatMask valid, IntVector row,
                             const BeamTable& beams, SpanList& list) {
  const Floats d;
  valid = hn::And(valid, lanes.valid);
  append_spans(lanes, lanes.from, lanes.to, valid, row, beams, list);
  const FloatMask twice = hn::And(valid, lanes.twice);
  if (HWY_LIKELY(hn::AllFalse(d, twice))) return;
  const FloatVector turn = hn::Set(d, kFullTurn);
  append_spans(lanes, hn::Add(lanes.from, turn), hn::Add(lanes.to, turn), twice, row, beams, list);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
