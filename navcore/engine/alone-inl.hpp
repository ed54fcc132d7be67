// Private to this folder: what scans see that share their cells with too few others.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_ALONE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_ALONE_INL
#undef MAPWRIGHT_ENGINE_ALONE_INL
#else
#define MAPWRIGHT_ENGINE_ALONE_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "navcore/engine/search-inl.hpp"
#include "navcore/engine/spans-inl.hpp"
#include "navcore/engine/stairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Scans that are cast together. The i-th is the scan of start starts[i], its inverse ranges are
// Workspace::inverse(i).
using ScansTogether = std::span<const StartInCell>;

// Asks for a cell's list ahead of time: as many lines as most lists have.
HWY_INLINE void ask_for(const PackedCell& cell) {
  constexpr int kUsualLines = 5;
  const auto* bytes = reinterpret_cast<const char*>(&cell);
  for (int line = 0; line < kUsualLines; ++line) {
    __builtin_prefetch(bytes + line * static_cast<int>(kLine));
  }
}

// Lists the walls (or else the ramps) that scans may meet. Asks for the lists of those that are
// next, one by one: all at once they would queue up.
template <bool kTwoSided>
HWY_INLINE void find_walls_of(const ScanSetup& setup, ScansTogether scans, ScansTogether next,
                              Workspace& work) {
  search(
      setup, scans.size(), work.lasers, work.candidates,
      [&](std::size_t i) MAPWRIGHT_INLINE_LAMBDA {
        const PackedCell* const cell = scans[i].cell;
        return ViewedRun{cell, kTwoSided ? cell->two_sided() : cell->one_sided()};
      },
      [&](std::size_t i) MAPWRIGHT_INLINE_LAMBDA {
        if (i < next.size()) ask_for(*next[i].cell);
      });
  work.walls.make_room(2 * work.candidates.size);
  const IntVector rows = hn::Load(Ints(), work.rows.data());
  for_each_candidate(work.candidates, work.lasers, *setup.beams,
                     [&](const LaneSpans& lanes, FloatMask real, IntVector scan,
                         IntVector segment) MAPWRIGHT_INLINE_LAMBDA {
                       const auto of = hn::IndicesFromVec(Ints(), scan);
                       const FloatMask valid = kTwoSided ? real : hn::And(real, lanes.low_side);
                       append_spans(lanes, valid, hn::TableLookupLanes(rows, of), *setup.beams,
                                    work.walls, NoNote());
                       for_rare_lanes(hn::And(real, lanes.near_line), [&](std::uint32_t i) {
                         HWY_ALIGN std::int32_t scan_of[kBlock], segment_of[kBlock];
                         hn::Store(scan, Ints(), scan_of);
                         hn::Store(segment, Ints(), segment_of);
                         const auto s = static_cast<std::size_t>(scan_of[i]);
                         work.touched_walls.push_back(
                             {scans[s], static_cast<std::uint32_t>(segment_of[i]), work.row(s)});
                       });
                     });
}

HWY_INLINE void find_walls(const ScanSetup& setup, const ScanStarts& starts, ScansTogether scans,
                           ScansTogether next, Workspace& work) {
  bool ramps = false;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    set_laser(starts, scans[i].start, i, work.lasers);
    ramps |= scans[i].cell->one_sided_count != 0;
  }
  find_walls_of<true>(setup, scans, next, work);
  if (HWY_UNLIKELY(ramps)) find_walls_of<false>(setup, scans, {}, work);
}

// -- staircases --------------------------------------------------------------------------------

// Staircases that are searched together, each for one scan. They are views `first`, first + 1, …
struct StairsTogether {
  void add(const PackedCell& cell, const PackedStairs& stairs) {
    runs[count] = {&cell, stairs.segments};
    low_step[count] = static_cast<std::int32_t>(stairs.first_low_step);
    stop[count] = static_cast<std::int32_t>(stairs.first_stop);
    ++count;
  }

  std::size_t first;
  std::size_t count = 0;
  ViewedRun runs[kBlock] = {};
  alignas(kLine) std::int32_t low_step[kBlock] = {};  ///< number of the first segment
  alignas(kLine) std::int32_t stop[kBlock] = {};
};

// Lists the steps of staircases.
HWY_INLINE void find_steps_of(const ScanSetup& setup, ScansTogether scans,
                              const StairsTogether& together, Workspace& work) {
  const Ints di;
  search(
      setup, together.count, work.stairs_lasers, work.candidates,
      [&](std::size_t i) MAPWRIGHT_INLINE_LAMBDA { return together.runs[i]; }, [](std::size_t) {});
  work.steps.make_room(2 * work.candidates.size);
  const IntVector rows = hn::Add(hn::Load(di, work.stairs_rows.data()),
                                 hn::Set(di, work.row(kStairsRows * together.first)));
  const IntVector low_step = hn::Load(di, together.low_step), stops = hn::Load(di, together.stop);
  for_each_candidate(
      work.candidates, work.stairs_lasers, *setup.beams,
      [&](const LaneSpans& lanes, FloatMask real, IntVector view, IntVector segment)
          MAPWRIGHT_INLINE_LAMBDA {
            const auto of = hn::IndicesFromVec(di, view);
            const auto is_top = hn::Gt(hn::TableLookupLanes(low_step, of), segment);
            const auto is_low = hn::Gt(hn::TableLookupLanes(stops, of), segment);
            const IntVector part =
                hn::IfThenElse(is_top, hn::Set(di, work.row(kTops)),
                               hn::IfThenElse(is_low, hn::Set(di, work.row(kLowSteps)),
                                              hn::Set(di, work.row(kStops))));
            const IntVector row = hn::Add(hn::TableLookupLanes(rows, of), part);
            HWY_ALIGN std::int32_t view_of[kBlock], segment_of[kBlock], row_of[kBlock];
            hn::Store(view, di, view_of);
            hn::Store(segment, di, segment_of);
            hn::Store(row, di, row_of);
            const FloatMask stop = hn::Not(hn::RebindMask(Floats(), is_low));
            append_spans(lanes, real, row, *setup.beams, work.steps,
                         [&](FloatMask seen, FloatVector first, FloatVector end)
                             MAPWRIGHT_INLINE_LAMBDA {
                               HWY_ALIGN float first_of[kBlock], end_of[kBlock];
                               hn::Store(first, Floats(), first_of);
                               hn::Store(end, Floats(), end_of);
                               for_rare_lanes(hn::And(seen, stop), [&](std::uint32_t i) {
                                 const auto v = static_cast<std::size_t>(view_of[i]);
                                 work.stairs_views[together.first + v].add(
                                     static_cast<std::int32_t>(first_of[i] - kWhole),
                                     static_cast<std::int32_t>(end_of[i] - kWhole));
                               });
                             });
            for_rare_lanes(hn::And(real, lanes.near_line), [&](std::uint32_t i) {
              const auto v = static_cast<std::size_t>(view_of[i]);
              StairsView& seen = work.stairs_views[together.first + v];
              work.touched_steps.push_back(
                  {scans[seen.scan], static_cast<std::uint32_t>(segment_of[i]), row_of[i]});
              if (segment_of[i] >= together.stop[v]) {
                seen.add(0, static_cast<std::int32_t>(setup.beams->rays));
              }
            });
          });
}

// Lists what scans see of staircases of which they see stops.
HWY_INLINE void find_steps(const ScanSetup& setup, const ScanStarts& starts, ScansTogether scans,
                           Workspace& work) {
  std::size_t with_stairs[kTogether];
  std::size_t count = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    with_stairs[count] = i;
    count += scans[i].cell->stairs_count != 0 ? 1 : 0;
  }
  StairsTogether together{0};
  const auto search_together = [&]() HWY_ATTR {
    find_steps_of(setup, scans, together, work);
    together = {work.stairs_views.size()};
  };
  for (std::size_t i = 0; i < count; ++i) {
    const StartInCell& scan = scans[with_stairs[i]];
    for (const PackedStairs& stairs : scan.cell->stairs()) {
      set_laser(starts, scan.start, together.count, work.stairs_lasers);
      work.stairs_views.push_back(
          {with_stairs[i], kStairsRows * work.stairs_views.size(), kNoRay, 0});
      together.add(*scan.cell, stairs);
      if (together.count == kTogether) search_together();
    }
  }
  work.make_stairs_rows(kStairsRows * work.stairs_views.size());
  if (together.count != 0) search_together();
  std::erase_if(work.stairs_views, [](const StairsView& view) { return view.first >= view.end; });
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
