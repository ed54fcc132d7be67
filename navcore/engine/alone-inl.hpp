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

// Calls list(real lanes, where they come from, add) for the candidates of scans, a vector at a
// time; add(lanes, found) lists what those lanes meet. The buffer of a scan is at its lane of
// `rows`.
template <bool kTwoSided, class List>
HWY_INLINE void list_candidates(const ScanSetup& setup, ScansTogether scans,
                                const LaserTable& lasers, IntVector rows,
                                const Candidates& candidates, List&& list) {
  const Ints di;
  for_each_candidate(
      candidates, lasers, *setup.beams,
      [&](const LaneSpans& lanes, FloatMask real, IntVector scan, IntVector source)
          MAPWRIGHT_INLINE_LAMBDA {
            const IntVector row = hn::TableLookupLanes(rows, hn::IndicesFromVec(di, scan));
            list(real, source, [&](FloatMask those, FoundSpans& found) MAPWRIGHT_INLINE_LAMBDA {
              const FloatMask valid = kTwoSided ? those : hn::And(those, lanes.low_side);
              append_spans(lanes, valid, row, *setup.beams, found.spans);
              for_rare_lanes(hn::And(those, lanes.near_line), [&](std::uint32_t i) {
                HWY_ALIGN std::int32_t scan_of[kBlock], source_of[kBlock], row_of[kBlock];
                hn::Store(scan, di, scan_of);
                hn::Store(source, di, source_of);
                hn::Store(row, di, row_of);
                found.touched.push_back({scans[static_cast<std::size_t>(scan_of[i])],
                                         segment_of(source_of[i]), row_of[i]});
              });
            });
          });
}

// Some of the scans that are cast together.
struct ChosenScans {
  HWY_INLINE void add_if(bool chosen, std::size_t scan) {
    scans[count] = scan;
    count += chosen ? 1 : 0;
  }

  std::size_t count = 0;
  std::size_t scans[kBlock + 1];
};

// Lists what some scans meet of their lists; run_of(list) is where.
template <bool kTwoSided, class RunOf>
HWY_INLINE void find_some(const ScanSetup& setup, ScansTogether scans, const ChosenScans& some,
                          const LaserTable& lasers, IntVector rows, Candidates& candidates,
                          FoundSpans& found, RunOf&& run_of) {
  candidates.size = 0;
  search(
      setup, some.count, lasers, candidates,
      [&](std::size_t k) MAPWRIGHT_INLINE_LAMBDA { return some.scans[k]; },
      [&](std::size_t i) MAPWRIGHT_INLINE_LAMBDA {
        return ViewedRun{scans[i].cell, run_of(*scans[i].cell)};
      },
      [](std::size_t) {});
  found.spans.make_room(2 * candidates.size);
  list_candidates<kTwoSided>(setup, scans, lasers, rows, candidates,
                             [&](FloatMask real, IntVector, auto&& add)
                                 MAPWRIGHT_INLINE_LAMBDA { add(real, found); });
}

// Lists what scans meet of staircases, each in rows of its own.
HWY_NOINLINE void find_steps_with_rows(const ScanSetup& setup, ScansTogether scans,
                                       ChosenScans some, const LaserTable& lasers,
                                       Workspace& work) {
  const Ints di;
  for (std::size_t number = 0; some.count != 0; ++number) {
    const std::size_t first_row = number * kBlock * kStairsRows;
    const auto find_rows = [&](StairsRow row, SegmentRun PackedStairs::*part) HWY_ATTR {
      const IntVector rows =
          hn::Add(hn::Load(di, work.stairs_rows.data()), hn::Set(di, work.row(first_row + row)));
      find_some<true>(setup, scans, some, lasers, rows, work.candidates, work.steps,
                      [&](const PackedCell& cell) { return cell.stairs()[number].*part; });
    };
    find_rows(kTops, &PackedStairs::tops);
    find_rows(kLowSteps, &PackedStairs::low_steps);
    find_rows(kStops, &PackedStairs::stops);
    ChosenScans with_more;
    for (std::size_t k = 0; k < some.count; ++k) {
      const std::size_t i = some.scans[k];
      work.stairs_views.push_back({i, first_row + i * kStairsRows});
      with_more.add_if(scans[i].cell->stairs_count > number + 1, i);
    }
    work.make_stairs_rows(first_row + kBlock * kStairsRows);
    some = with_more;
  }
}

// Lists what scans meet. Asks for the lists of those that are next and clears the buffers one by
// one: all at once they would queue up.
HWY_INLINE void find_all(const ScanSetup& setup, ScansTogether scans, ScansTogether next,
                         const LaserTable& lasers, Workspace& work) {
  const Floats d;
  const Ints di;
  const IntVector rows = hn::Load(di, work.rows.data());
  Candidates& candidates = work.candidates;
  candidates.size = 0;
  ChosenScans with_ramps, with_stairs;
  search(
      setup, scans.size(), lasers, candidates, [](std::size_t i) { return i; },
      [&](std::size_t i) MAPWRIGHT_INLINE_LAMBDA {
        const PackedCell& cell = *scans[i].cell;
        return ViewedRun{&cell, cell.two_sided(), cell.first_stop, cell.first_top};
      },
      [&](std::size_t i) MAPWRIGHT_INLINE_LAMBDA {
        with_ramps.add_if(scans[i].cell->one_sided_count != 0, i);
        with_stairs.add_if(scans[i].cell->stairs_count != 0, i);
        if (i < next.size()) ask_for(*next[i].cell);
        clear_inverse(*setup.beams, work.inverse(i));
      });
  for (FoundSpans* found : {&work.walls, &work.lone_stops, &work.lone_tops}) {
    found->spans.make_room(2 * candidates.size);
  }
  list_candidates<true>(setup, scans, lasers, rows, candidates,
                        [&](FloatMask real, IntVector source, auto&& add) MAPWRIGHT_INLINE_LAMBDA {
                          const auto is_before = [&](std::int32_t bit) MAPWRIGHT_INLINE_LAMBDA {
                            return hn::RebindMask(d, hn::Gt(hn::Set(di, bit), source));
                          };
                          const FloatMask is_wall = is_before(kIsStop);
                          add(hn::And(real, is_wall), work.walls);
                          if (HWY_LIKELY(hn::AllFalse(d, hn::AndNot(is_wall, real)))) return;
                          const FloatMask is_before_tops = is_before(kIsTop);
                          add(hn::And(real, hn::AndNot(is_wall, is_before_tops)), work.lone_stops);
                          add(hn::AndNot(is_before_tops, real), work.lone_tops);
                        });
  if (HWY_UNLIKELY(with_ramps.count != 0)) {
    find_some<false>(setup, scans, with_ramps, lasers, rows, candidates, work.walls,
                     [](const PackedCell& cell) { return cell.one_sided(); });
  }
  if (HWY_UNLIKELY(with_stairs.count != 0)) {
    find_steps_with_rows(setup, scans, with_stairs, lasers, work);
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
