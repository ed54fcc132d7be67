// Private to this folder: casts whole scans.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_CAST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_CAST_INL
#undef MAPWRIGHT_ENGINE_CAST_INL
#else
#define MAPWRIGHT_ENGINE_CAST_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "navcore/engine/kernels.hpp"
#include "navcore/engine/near_line.hpp"
#include "navcore/engine/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The beam table's arrays. A copy of one's own tells the compiler that no store changes them.
struct RayArrays {
  explicit RayArrays(const BeamTable& beams)
      : bearing(beams.bearing.data()), cosine(beams.cosine.data()), sine(beams.sine.data()) {}
  const float* bearing;
  const float* cosine;
  const float* sine;
};

/// One segment's part in the scan, in registers.
struct Span {
  HWY_INLINE Span(const SpanBlock& block, std::size_t i)
      : cosine(hn::Set(Floats(), block.cosine[i])),
        sine(hn::Set(Floats(), block.sine[i])),
        from(hn::Set(Floats(), block.from[i])),
        to(hn::Set(Floats(), block.to[i])) {}
  FloatVector cosine, sine, from, to;
};

// Raises the inverse ranges of those of the rays ray, ray + 1, … that meet the span.
HWY_INLINE void raise_rays(const RayArrays& rays, const Span& span, std::size_t ray,
                           float* HWY_RESTRICT inverse) {
  const Floats d;
  const FloatVector bearing = hn::Load(d, rays.bearing + ray);
  const FloatMask met = hn::And(hn::Ge(bearing, span.from), hn::Le(bearing, span.to));
  const FloatVector value = hn::MulAdd(span.cosine, hn::Load(d, rays.cosine + ray),
                                       hn::Mul(span.sine, hn::Load(d, rays.sine + ray)));
  const FloatVector old = hn::Load(d, inverse + ray);
  hn::Store(hn::Max(old, hn::IfThenElseZero(met, value)), d, inverse + ray);
}

// Raises the inverse ranges of the rays that meet span i. Two vectors are done without asking: most
// spans need one or two, and which is a coin that branch prediction loses. For that the arrays are
// one block longer than the rays.
HWY_INLINE void raise_span(const RayArrays& rays, const SpanBlock& block, std::size_t i,
                           float* HWY_RESTRICT inverse) {
  const std::size_t step = hn::Lanes(Floats());
  const Span span(block, i);
  std::size_t ray = static_cast<std::size_t>(block.first[i]) & ~(step - 1);
  const auto last = static_cast<std::size_t>(block.last[i]);
  raise_rays(rays, span, ray, inverse);
  raise_rays(rays, span, ray + step, inverse);
  for (ray += 2 * step; ray <= last; ray += step) raise_rays(rays, span, ray, inverse);
}

// Raises what the spans of some blocks meet; `buffer(lane)` is where the span of a lane goes.
template <class Buffer>
HWY_INLINE void raise_blocks(const ScanSetup& setup, const ScanStart& start,
                             std::span<const SpanBlock> blocks, Buffer&& buffer) {
  const RayArrays rays(*setup.beams);
  for (const SpanBlock& block : blocks) {
    for (std::uint32_t bits = block.seen; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::uint32_t>(__builtin_ctz(bits));
      raise_span(rays, block, i, buffer(block.first_lane + i));
    }
    for (std::uint32_t bits = block.near_line; HWY_UNLIKELY(bits != 0); bits &= bits - 1) {
      const std::uint32_t lane = block.first_lane + static_cast<std::uint32_t>(__builtin_ctz(bits));
      cast_at_item(*setup.scene, start.cell->item(lane), setup.height_m, *setup.beams, *start.pose,
                   buffer(lane));
    }
  }
}

HWY_INLINE void fill(AlignedFloats& array, float value) {
  const Floats d;
  const FloatVector v = hn::Set(d, value);
  for (std::size_t i = 0; i < array.size(); i += hn::Lanes(d)) hn::Store(v, d, array.data() + i);
}

// Report, figure 6: where the first segment met is a top, the staircase is crossed; elsewhere the
// nearest step higher than the laser stops the ray.
HWY_INLINE void combine_stairs(Workspace& work) {
  const Floats d;
  for (std::size_t i = 0; i < work.inverse.size(); i += hn::Lanes(d)) {
    const FloatVector stop = hn::Load(d, work.stops.data() + i);
    const FloatVector step = hn::Max(stop, hn::Load(d, work.low_steps.data() + i));
    const FloatMask stopped = hn::Ge(step, hn::Load(d, work.tops.data() + i));
    const FloatVector old = hn::Load(d, work.inverse.data() + i);
    hn::Store(hn::Max(old, hn::IfThenElseZero(stopped, stop)), d, work.inverse.data() + i);
  }
}

// True if some span of a stop is in view.
HWY_INLINE bool sees_stop(const PackedStairs& stairs, std::span<const SpanBlock> blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [&](const SpanBlock& block) {
    const std::uint32_t any = block.seen | block.near_line;
    return any != 0 &&
           stairs.is_stop(block.first_lane + 31U - static_cast<std::uint32_t>(__builtin_clz(any)));
  });
}

HWY_NOINLINE void cast_at_stairs(const ScanSetup& setup, const ScanStart& start,
                                 const PackedStairs& stairs, std::span<const SpanBlock> blocks,
                                 Workspace& work) {
  if (!sees_stop(stairs, blocks)) return;
  for (AlignedFloats* buffer : {&work.stops, &work.low_steps, &work.tops}) fill(*buffer, 0.0F);
  raise_blocks(setup, start, blocks,
               [&](std::uint32_t lane) { return work.buffer_of(stairs, lane); });
  combine_stairs(work);
}

// Inverse ranges of one scan, at least 1/RMAX, into `work.inverse`. `section` is the first of the
// scan's sections of spans; returns the first of the next scan's.
HWY_INLINE std::size_t cast_scan(const ScanSetup& setup, const ScanStart& start,
                                 std::size_t section, Workspace& work) {
  fill(work.inverse, setup.beams->inverse_max_range);
  float* const inverse = work.inverse.data();
  raise_blocks(setup, start, work.section(section++), [=](std::uint32_t) { return inverse; });
  for (const PackedStairs& stairs : start.cell->stairs()) {
    cast_at_stairs(setup, start, stairs, work.section(section++), work);
  }
  return section;
}

// Ranges of the rays i, i + 1, … from the inverse ranges.
HWY_INLINE FloatVector ranges_at(const BeamTable& beams, const Workspace& work, std::size_t i) {
  const Floats d;
  const FloatVector inverse = hn::Load(d, work.inverse.data() + i);
  const FloatVector range = reciprocal(d, inverse);
  const FloatVector longest = hn::Set(d, beams.max_range_m);
  const FloatMask hit = hn::Gt(inverse, hn::Set(d, beams.inverse_max_range));
  return hn::IfThenElse(hit, hn::Min(range, longest), longest);
}

// Asks for a cell's list ahead of time: its header and its first two blocks.
HWY_INLINE void prefetch(const PackedCell& cell) {
  const auto* bytes = reinterpret_cast<const char*>(&cell);
  for (int line = 0; line < 9; ++line) __builtin_prefetch(bytes + line * static_cast<int>(kLine));
}

// Calls `finish(i)` when the inverse ranges of scan i are in the workspace. Scans go through the
// two stages in groups: the spans of one scan come out of a long chain of dependent operations, and
// the processor works on several such chains at a time as long as no branch hangs on their outcome.
template <class Finish>
HWY_INLINE void for_each_scan(const ScanSetup& setup, std::span<const ScanStart> starts,
                              Workspace& work, Finish&& finish) {
  constexpr std::size_t kGroup = 4;
  for (std::size_t begin = 0; begin < starts.size(); begin += kGroup) {
    const std::size_t end = std::min(starts.size(), begin + kGroup);
    const std::size_t ahead = std::min(starts.size(), end + kGroup);
    for (std::size_t i = end; i < ahead; ++i) prefetch(*starts[i].cell);
    work.clear();
    for (std::size_t i = begin; i < end; ++i) find_spans_of_scan(starts[i], *setup.beams, work);
    std::size_t section = 0;
    for (std::size_t i = begin; i < end; ++i) {
      section = cast_scan(setup, starts[i], section, work);
      finish(i);
    }
  }
}

void cast_scans(const ScanSetup& setup, std::span<const ScanStart> starts, Workspace& work,
                float* ranges) {
  const BeamTable& beams = *setup.beams;
  for_each_scan(setup, starts, work, [&](std::size_t scan) HWY_ATTR {
    const Floats d;
    float* const out = ranges + scan * beams.rays;
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= beams.rays; i += hn::Lanes(d)) {
      hn::StoreU(ranges_at(beams, work, i), d, out + i);
    }
    if (i == beams.rays) return;
    HWY_ALIGN float rest[kBlock];
    hn::Store(ranges_at(beams, work, i), d, rest);
    std::copy_n(rest, beams.rays - i, out + i);
  });
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
