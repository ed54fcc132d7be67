// Private to this folder: finds the segments in front of several lasers, each with a list of its
// own.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_SEARCH_INL
#undef MAPWRIGHT_ENGINE_SEARCH_INL
#else
#define MAPWRIGHT_ENGINE_SEARCH_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

#include "navcore/engine/kernels.hpp"
#include "navcore/engine/packing-inl.hpp"
#include "navcore/engine/workspace.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Views that are searched together: as many as a vector has lanes, to look lasers up in registers.
constexpr std::size_t kTogether = hn::MaxLanes(Floats());

HWY_INLINE void set_laser(const ScanStarts& starts, std::uint32_t start, std::size_t view,
                          LaserTable& lasers) {
  lasers.x[view] = starts.x[start];
  lasers.y[view] = starts.y[start];
  lasers.cosine[view] = starts.cosine[start];
  lasers.sine[view] = starts.sine[start];
}

// Lists the blocks of a run. Whether there is a second one is a coin that branch prediction loses,
// so it is written in any case. Requires room.
HWY_INLINE void append_blocks(const PackedCell& cell, SegmentRun run, std::size_t view,
                              BlocksToSearch& list) {
  constexpr auto kStep = static_cast<std::uint32_t>(kTogether);
  const std::uint32_t blocks = (run.count + kStep - 1) / kStep;
  const float* const ends = cell.ends(run);
  BlockToSearch* const out = list.blocks.data() + list.size;
  const auto write = [&](std::uint32_t i) MAPWRIGHT_INLINE_LAMBDA {
    const std::uint32_t skip = i * kStep;
    out[i] = {ends + skip, run.count, run.first + skip, std::min(run.count - skip, kStep),
              static_cast<std::uint32_t>(view)};
  };
  for (std::uint32_t i = 0; i < kUsualBlocks; ++i) write(i);
  for (std::uint32_t i = kUsualBlocks; HWY_UNLIKELY(i < blocks); ++i) write(i);
  list.size += blocks;
}

// The ends of segments, and zeros: what stands behind them in memory are whole numbers, and as
// floats those would be so small that they cost a hundred cycles.
struct Ends {
  HWY_INLINE Ends(const float* at, std::uint32_t stride, FloatMask real)
      : ax(load(at, real)),
        ay(load(at + stride, real)),
        bx(load(at + std::size_t{2} * stride, real)),
        by(load(at + std::size_t{3} * stride, real)) {}

  static HWY_INLINE FloatVector load(const float* at, FloatMask real) {
    return hn::IfThenElseZero(real, hn::LoadU(Floats(), at));
  }

  FloatVector ax, ay, bx, by;
};

// Which segments a field of view up to 180° may meet: not those that lie behind the laser by more
// than `behind_m`, for then no ray to the front or to the sides comes near them.
HWY_INLINE FloatMask in_front(const Ends& ends, float x, float y, float cosine, float sine,
                              float behind_m) {
  const Floats d;
  const FloatVector c = hn::Set(d, cosine), s = hn::Set(d, sine);
  const FloatVector a = hn::MulAdd(ends.ax, c, hn::Mul(ends.ay, s));
  const FloatVector b = hn::MulAdd(ends.bx, c, hn::Mul(ends.by, s));
  return hn::Gt(hn::Max(a, b), hn::Set(d, x * cosine + y * sine - behind_m));
}

// Makes candidates of those segments of the blocks that their scans may meet.
HWY_INLINE void search(const ScanSetup& setup, const BlocksToSearch& blocks,
                       const LaserTable& lasers, Candidates& candidates) {
  const Floats d;
  const Ints di;
  candidates.size = 0;
  candidates.make_room(blocks.size * hn::Lanes(d));
  for (std::size_t i = 0; i < blocks.size; ++i) {
    const BlockToSearch& b = blocks.blocks[i];
    const FloatMask real = hn::FirstN(d, b.count);
    const Ends ends(b.ends, b.stride, real);
    FloatMask chosen = real;
    if (setup.beams->looks_ahead) {
      chosen =
          hn::And(chosen, in_front(ends, lasers.x[b.view], lasers.y[b.view], lasers.cosine[b.view],
                                   lasers.sine[b.view], setup.behind_m));
    }
    const ChosenLanes lanes(chosen);
    const std::size_t at = candidates.size;
    hn::StoreU(lanes.pack(ends.ax), d, candidates.ax.data() + at);
    hn::StoreU(lanes.pack(ends.ay), d, candidates.ay.data() + at);
    hn::StoreU(lanes.pack(ends.bx), d, candidates.bx.data() + at);
    hn::StoreU(lanes.pack(ends.by), d, candidates.by.data() + at);
    const auto source = static_cast<std::int32_t>(b.first * kBlock + b.view);
    hn::StoreU(hn::Add(hn::ShiftLeft<4>(lanes.numbers()), hn::Set(di, source)), di,
               candidates.source.data() + at);
    candidates.size += lanes.count();
  }
}

// Calls f(spans, real lanes, views, segments of their lists) for the candidates, a vector at a
// time.
template <class F>
HWY_INLINE void for_each_candidate(const Candidates& candidates, const LaserTable& lasers,
                                   const BeamTable& beams, F&& f) {
  static_assert(kBlock == 16);
  const Floats d;
  const Ints di;
  const FloatVector x = hn::Load(d, lasers.x), y = hn::Load(d, lasers.y);
  const FloatVector cosine = hn::Load(d, lasers.cosine), sine = hn::Load(d, lasers.sine);
  for (std::size_t i = 0; i < candidates.size; i += hn::Lanes(d)) {
    const IntVector source = hn::Load(di, candidates.source.data() + i);
    const FloatMask real = hn::FirstN(d, std::min(candidates.size - i, hn::Lanes(d)));
    const IntVector view = hn::And(source, hn::Set(di, static_cast<std::int32_t>(kTogether) - 1));
    const auto of = hn::IndicesFromVec(d, view);
    const LaserLanes laser{hn::TableLookupLanes(x, of), hn::TableLookupLanes(y, of),
                           hn::TableLookupLanes(cosine, of), hn::TableLookupLanes(sine, of)};
    const FloatVector ax = hn::Load(d, candidates.ax.data() + i);
    const FloatVector ay = hn::Load(d, candidates.ay.data() + i);
    const FloatVector bx = hn::Load(d, candidates.bx.data() + i);
    const FloatVector by = hn::Load(d, candidates.by.data() + i);
    const EndLanes a(ax, ay, laser), b(bx, by, laser);
    f(lane_spans({a, hn::Sub(bx, ax), hn::Sub(by, ay), a.bearing(), b.bearing()}, laser, beams),
      real, view, hn::ShiftRight<4>(source));
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
