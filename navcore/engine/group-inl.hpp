// Private to this folder: several scans from one cell, a scan in each lane.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_GROUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_GROUP_INL
#undef MAPWRIGHT_ENGINE_GROUP_INL
#else
#define MAPWRIGHT_ENGINE_GROUP_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstdint>

#include "navcore/engine/kernels.hpp"
#include "navcore/engine/spans-inl.hpp"
#include "navcore/engine/stairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Scans from `first` on; in the lanes beyond `count` stands something else.
struct ScanGroup {
  const PackedCell* cell;
  std::uint32_t first, count;

  StartInCell start(std::uint32_t i) const { return {cell, first + i}; }
};

HWY_INLINE LaserLanes lasers_of(const ScanStarts& starts, const ScanGroup& group) {
  const Floats d;
  const std::uint32_t i = group.first;
  return {hn::LoadU(d, starts.x + i), hn::LoadU(d, starts.y + i), hn::LoadU(d, starts.cosine + i),
          hn::LoadU(d, starts.sine + i)};
}

// Ends that lie so far behind the laser that no ray to the front or to the sides comes near them.
HWY_INLINE FloatMask behind(const EndLanes& end) {
  const Floats d;
  constexpr float kMargin_m = 1e-4F, kMargin_rad = 2e-6F;
  const FloatVector margin =
      hn::MulAdd(hn::Abs(end.left), hn::Set(d, kMargin_rad), hn::Set(d, kMargin_m));
  return hn::Lt(hn::Add(end.ahead, margin), hn::Zero(d));
}

// One end of one segment; its bearings are computed when they are first asked for.
class SharedEnd {
 public:
  HWY_INLINE SharedEnd(float x, float y, const LaserLanes& lasers)
      : lanes(hn::Set(Floats(), x), hn::Set(Floats(), y), lasers),
        is_behind(behind(lanes)),
        x_(x),
        y_(y) {}

  HWY_INLINE bool is_at(float x, float y) const {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(x_) &&
           std::bit_cast<std::uint32_t>(y) == std::bit_cast<std::uint32_t>(y_);
  }
  HWY_INLINE FloatVector bearing() {
    if (!has_bearing_) bearing_ = lanes.bearing();
    has_bearing_ = true;
    return bearing_;
  }

  EndLanes lanes;
  FloatMask is_behind;

 private:
  float x_, y_;
  bool has_bearing_ = false;
  FloatVector bearing_;
};

// The segments begin, …, end − 1 of a run.
struct PartOfRun {
  PartOfRun(SegmentRun whole) : run(whole), end(whole.count) {}
  PartOfRun(SegmentRun whole, std::uint32_t from, std::uint32_t to)
      : run(whole), begin(from), end(to) {}

  SegmentRun run;
  std::uint32_t begin = 0, end;
};

// Calls f(spans, segment) for those segments of a part that are not behind all of the `real` lanes.
// Of a chain every end is computed once.
template <class F>
HWY_INLINE void for_each_segment(const PackedCell& cell, const PartOfRun& part,
                                 const LaserLanes& lasers, FloatMask real, const BeamTable& beams,
                                 F&& f) {
  const Floats d;
  if (part.begin == part.end) return;
  const SegmentRun run = part.run;
  const float* const ax = cell.ends(run);
  const float* const ay = ax + run.count;
  const float* const bx = ay + run.count;
  const float* const by = bx + run.count;
  SharedEnd b(ax[part.begin], ay[part.begin], lasers);
  for (std::uint32_t i = part.begin; i < part.end; ++i) {
    const float x0 = ax[i], y0 = ay[i], x1 = bx[i], y1 = by[i];
    SharedEnd a = b.is_at(x0, y0) ? b : SharedEnd(x0, y0, lasers);
    b = SharedEnd(x1, y1, lasers);
    const FloatMask hidden = hn::And(a.is_behind, b.is_behind);
    if (beams.looks_ahead && hn::AllFalse(d, hn::AndNot(hidden, real))) continue;
    f(lane_spans({a.lanes, hn::Set(d, x1 - x0), hn::Set(d, y1 - y0), a.bearing(), b.bearing()},
                 lasers, beams),
      run.first + i);
  }
}

// Lists what scans of a group meet of some segments. The buffer of a scan is at its lane of `rows`.
template <bool kTwoSided = true>
HWY_INLINE void find(const ScanStarts& starts, const ScanGroup& group, const PartOfRun& part,
                     const BeamTable& beams, IntVector rows, FoundSpans& found) {
  const Floats d;
  const Ints di;
  const FloatMask real = hn::FirstN(d, group.count);
  found.spans.make_room(2 * hn::Lanes(d) * (part.end - part.begin));
  for_each_segment(*group.cell, part, lasers_of(starts, group), real, beams,
                   [&](const LaneSpans& lanes, std::uint32_t segment) MAPWRIGHT_INLINE_LAMBDA {
                     const FloatMask valid = kTwoSided ? real : hn::And(real, lanes.low_side);
                     append_spans(lanes, valid, rows, beams, found.spans);
                     for_rare_lanes(hn::And(real, lanes.near_line), [&](std::uint32_t i) {
                       HWY_ALIGN std::int32_t row_of[kBlock];
                       hn::Store(rows, di, row_of);
                       found.touched.push_back({group.start(i), segment, row_of[i]});
                     });
                   });
}

// Lists what scans of a group meet of staircases, each in rows of its own.
HWY_NOINLINE void find_steps_with_rows(const ScanStarts& starts, const ScanGroup& group,
                                       const BeamTable& beams, Workspace& work) {
  const Ints di;
  std::size_t first_row = 0;
  for (const PackedStairs& stairs : group.cell->stairs()) {
    const auto find_rows = [&](StairsRow row, SegmentRun run) HWY_ATTR {
      const IntVector rows =
          hn::Add(hn::Load(di, work.stairs_rows.data()), hn::Set(di, work.row(first_row + row)));
      find(starts, group, run, beams, rows, work.steps);
    };
    find_rows(kTops, stairs.tops);
    find_rows(kLowSteps, stairs.low_steps);
    find_rows(kStops, stairs.stops);
    for (std::size_t i = 0; i < group.count; ++i) {
      work.stairs_views.push_back({i, first_row + i * kStairsRows});
    }
    first_row += kBlock * kStairsRows;
  }
  work.make_stairs_rows(first_row);
}

// Lists what scans of a group meet.
HWY_INLINE void find_all(const ScanStarts& starts, const ScanGroup& group, const BeamTable& beams,
                         Workspace& work) {
  const PackedCell& cell = *group.cell;
  const IntVector rows = hn::Load(Ints(), work.rows.data());
  const SegmentRun run = cell.two_sided();
  find(starts, group, {run, 0, cell.first_stop}, beams, rows, work.walls);
  find<false>(starts, group, cell.one_sided(), beams, rows, work.walls);
  find(starts, group, {run, cell.first_stop, cell.first_top}, beams, rows, work.lone_stops);
  if (!work.lone_stops.empty()) {
    find(starts, group, {run, cell.first_top, run.count}, beams, rows, work.lone_tops);
  }
  if (cell.stairs_count != 0) find_steps_with_rows(starts, group, beams, work);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
