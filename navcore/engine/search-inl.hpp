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

// What lies further behind its laser than `behind_m` comes near no ray to the front or to the
// sides.
HWY_INLINE void set_least(float behind_m, LaserTable& lasers) {
  const Floats d;
  const FloatVector across = hn::Mul(hn::Load(d, lasers.y), hn::Load(d, lasers.sine));
  const FloatVector at = hn::MulAdd(hn::Load(d, lasers.x), hn::Load(d, lasers.cosine), across);
  hn::Store(hn::Sub(at, hn::Set(d, behind_m)), d, lasers.least);
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

// Which segments a field of view up to 180° may meet.
HWY_INLINE FloatMask in_front(const Ends& ends, const LaserTable& lasers, std::size_t view) {
  const Floats d;
  const FloatVector c = hn::Set(d, lasers.cosine[view]), s = hn::Set(d, lasers.sine[view]);
  const FloatVector a = hn::MulAdd(ends.ax, c, hn::Mul(ends.ay, s));
  const FloatVector b = hn::MulAdd(ends.bx, c, hn::Mul(ends.by, s));
  return hn::Gt(hn::Max(a, b), hn::Set(d, lasers.least[view]));
}

// What a view may meet: a run of a cell's list.
struct ViewedRun {
  const PackedCell* cell;
  SegmentRun run;
};

// Makes candidates of those of a run's segments in the vector from `skip` on that the view may
// meet. Requires room.
HWY_INLINE void search_vector(const ScanSetup& setup, const ViewedRun& viewed, std::uint32_t skip,
                              std::size_t view, const LaserTable& lasers, Candidates& candidates) {
  const Floats d;
  const Ints di;
  const SegmentRun run = viewed.run;
  const FloatMask real = hn::FirstN(d, std::min<std::size_t>(run.count - skip, kTogether));
  const Ends ends(viewed.cell->ends(run) + skip, run.count, real);
  FloatMask chosen = real;
  if (setup.beams->looks_ahead) chosen = hn::And(real, in_front(ends, lasers, view));
  const ChosenLanes lanes(chosen);
  const std::size_t at = candidates.size;
  hn::StoreU(lanes.pack(ends.ax), d, candidates.ax.data() + at);
  hn::StoreU(lanes.pack(ends.ay), d, candidates.ay.data() + at);
  hn::StoreU(lanes.pack(ends.bx), d, candidates.bx.data() + at);
  hn::StoreU(lanes.pack(ends.by), d, candidates.by.data() + at);
  const auto source = static_cast<std::int32_t>((run.first + skip) * kBlock + view);
  hn::StoreU(hn::Add(hn::ShiftLeft<4>(lanes.numbers()), hn::Set(di, source)), di,
             candidates.source.data() + at);
  candidates.size += lanes.count();
}

// Makes candidates of those segments that up to kTogether views may meet; run_of(view) is what to
// search, ask_ahead(view) is called in between. Whether a run goes on after a vector is a coin that
// branch prediction loses: those that do come last.
template <class RunOf, class AskAhead>
HWY_INLINE void search(const ScanSetup& setup, std::size_t views, LaserTable& lasers,
                       Candidates& candidates, RunOf&& run_of, AskAhead&& ask_ahead) {
  set_least(setup.behind_m, lasers);
  std::size_t room = 0;
  for (std::size_t view = 0; view < views; ++view) room += run_of(view).run.count + kTogether;
  candidates.size = 0;
  candidates.make_room(room);
  std::size_t longer[kTogether];
  std::size_t count = 0;
  for (std::size_t view = 0; view < views; ++view) {
    const ViewedRun viewed = run_of(view);
    search_vector(setup, viewed, 0, view, lasers, candidates);
    ask_ahead(view);
    longer[count] = view;
    count += viewed.run.count > kTogether ? 1 : 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const ViewedRun viewed = run_of(longer[i]);
    for (std::uint32_t skip = kTogether; skip < viewed.run.count; skip += kTogether) {
      search_vector(setup, viewed, skip, longer[i], lasers, candidates);
    }
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
