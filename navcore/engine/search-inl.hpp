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

// Lasers of scans that are cast together. What lies further behind its laser than `behind_m` comes
// near no ray to the front or to the sides.
struct LaserTable {
  // Requires that `first` is a whole number of vectors.
  HWY_INLINE LaserTable(const ScanStarts& starts, std::size_t first, float behind_m)
      : x(starts.x + first),
        y(starts.y + first),
        cosine(starts.cosine + first),
        sine(starts.sine + first) {
    const Floats d;
    const FloatVector across = hn::Mul(hn::Load(d, y), hn::Load(d, sine));
    const FloatVector at = hn::MulAdd(hn::Load(d, x), hn::Load(d, cosine), across);
    hn::Store(hn::Sub(at, hn::Set(d, behind_m)), d, least);
  }

  const float* x;
  const float* y;
  const float* cosine;
  const float* sine;
  alignas(kLine) float least[kBlock];  ///< of x · cosine + y · sine that is not behind the laser
};

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

// Where candidates come from: kBlock · segment of the run + view, and what a segment of a lone
// staircase is.
constexpr std::int32_t kIsStop = 1 << 29, kIsTop = 2 * kIsStop;

constexpr std::uint32_t segment_of(std::int32_t source) {
  return static_cast<std::uint32_t>(source % kIsStop) / static_cast<std::uint32_t>(kBlock);
}

// What a view may meet: a run of a cell's list. Segments from first_stop on are stops, and from
// first_top on tops, of a lone staircase.
struct ViewedRun {
  const PackedCell* cell;
  SegmentRun run;
  std::uint32_t first_stop = INT32_MAX, first_top = INT32_MAX;
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
  const IntVector number =
      hn::Add(lanes.numbers(), hn::Set(di, static_cast<std::int32_t>(run.first + skip)));
  const auto kind = [&](std::uint32_t first, std::int32_t bit) MAPWRIGHT_INLINE_LAMBDA {
    const auto is_before = hn::Gt(hn::Set(di, static_cast<std::int32_t>(first)), number);
    return hn::IfThenZeroElse(is_before, hn::Set(di, bit));
  };
  const IntVector source =
      hn::Add(hn::ShiftLeft<4>(number), hn::Set(di, static_cast<std::int32_t>(view)));
  const IntVector kinds =
      hn::Add(kind(viewed.first_stop, kIsStop), kind(viewed.first_top, kIsTop - kIsStop));
  hn::StoreU(hn::Add(source, kinds), di, candidates.source.data() + at);
  candidates.size += lanes.count();
}

// Makes more candidates, of those segments that up to kTogether views may meet; the k-th is
// view_of(k), run_of(view) is what to search, ask_ahead(view) is called in between. Whether a run
// goes on after a vector is a coin that branch prediction loses: those that do come last.
template <class ViewOf, class RunOf, class AskAhead>
HWY_INLINE void search(const ScanSetup& setup, std::size_t views, const LaserTable& lasers,
                       Candidates& candidates, ViewOf&& view_of, RunOf&& run_of,
                       AskAhead&& ask_ahead) {
  std::size_t room = 0;
  for (std::size_t k = 0; k < views; ++k) room += run_of(view_of(k)).run.count + kTogether;
  candidates.make_room(room);
  std::size_t longer[kTogether];
  std::size_t count = 0;
  for (std::size_t k = 0; k < views; ++k) {
    const std::size_t view = view_of(k);
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

// Calls f(spans, real lanes, views, where they come from) for the candidates, a vector at a time.
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
      real, view, source);
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
