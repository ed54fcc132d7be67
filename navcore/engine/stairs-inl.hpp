// Private to this folder: staircases, which a ray may cross, and what single precision leaves over.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_STAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_STAIRS_INL
#undef MAPWRIGHT_ENGINE_STAIRS_INL
#else
#define MAPWRIGHT_ENGINE_STAIRS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

#include "navcore/engine/near_line.hpp"
#include "navcore/engine/raise-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Raises the buffers to what segments say whose lines run through the laser.
HWY_INLINE void raise_touched(const ScanSetup& setup, const ScanStarts& starts,
                              std::span<const TouchedItem> touched, float* buffers) {
  for (const TouchedItem& item : touched) {
    const Pose& pose = starts.poses[starts.scan[item.scan.start]];
    cast_at_item(*setup.scene, item.scan.cell->item(item.lane), setup.height_m, *setup.beams, pose,
                 buffers + item.row);
  }
}

// Rows of a staircase.
enum StairsRow : std::size_t { kTops, kLowSteps, kStops, kStairsRows };

// Rays that meet stops, in each lane, as ray_at() has them.
struct StoppedRays {
  HWY_INLINE StoppedRays() : first(hn::Set(Floats(), 2.0F * kWhole)), end(hn::Zero(Floats())) {}

  HWY_INLINE void add(FloatMask lanes, FloatVector from, FloatVector to) {
    first = hn::IfThenElse(lanes, hn::Min(first, from), first);
    end = hn::IfThenElse(lanes, hn::Max(end, to), end);
  }
  HWY_INLINE void add_all(FloatMask lanes, const BeamTable& beams) {
    const Floats d;
    add(lanes, hn::Set(d, kWhole), hn::Set(d, kWhole + static_cast<float>(beams.rays)));
  }
  HWY_INLINE FloatMask any() const { return hn::Lt(first, end); }

  FloatVector first, end;
};

HWY_INLINE StairsView stairs_view(std::size_t scan, std::size_t row, float first, float end) {
  const auto from = static_cast<std::int32_t>(first - kWhole);
  const auto to = static_cast<std::int32_t>(end - kWhole);
  return {scan, row, from & -kStep, (to + kStep - 1) & -kStep};
}

// Lists what the scan-th of the scans cast together sees of a staircase, if it sees stops.
HWY_INLINE void find_steps(const ScanStarts& starts, const StartInCell& start, std::size_t scan,
                           const PackedStairs& stairs, const BeamTable& beams, Workspace& work) {
  const Floats d;
  const Ints di;
  const auto number = [&](std::uint32_t lane) MAPWRIGHT_INLINE_LAMBDA {
    return hn::Set(di, static_cast<std::int32_t>(lane));
  };
  const std::size_t row = kStairsRows * work.stairs_views.size();
  const std::size_t size_before = work.steps.size, lanes_before = work.steps.lanes;
  const std::size_t touched_before = work.touched_steps.size();
  StoppedRays stopped;
  work.make_stairs_rows(row + kStairsRows);
  work.steps.make_room(2 * start.cell->lanes);
  for_each_block(
      *start.cell, stairs.lanes, laser_of(starts, start.start), beams,
      [&](const LaneSpans& lanes, std::uint32_t first_lane) MAPWRIGHT_INLINE_LAMBDA {
        const IntVector lane = hn::Iota(di, static_cast<std::int32_t>(first_lane));
        const auto low = hn::Lt(lane, number(stairs.first_stop));
        const auto top = hn::Lt(lane, number(stairs.first_low_step));
        const FloatMask stop = hn::Not(hn::RebindMask(d, low));
        const IntVector rows =
            hn::IfThenElse(top, hn::Set(di, work.row(row + kTops)),
                           hn::IfThenElse(low, hn::Set(di, work.row(row + kLowSteps)),
                                          hn::Set(di, work.row(row + kStops))));
        append_spans(lanes, lanes.valid, rows, beams, work.steps,
                     [&](FloatMask seen, FloatVector first, FloatVector end)
                         MAPWRIGHT_INLINE_LAMBDA { stopped.add(hn::And(seen, stop), first, end); });
        stopped.add_all(hn::And(lanes.near_line, stop), beams);
        for_rare_lanes(lanes.near_line, [&](std::uint32_t i) {
          const std::uint32_t at = first_lane + i;
          const std::size_t part = stairs.is_top(at)    ? kTops
                                   : stairs.is_stop(at) ? kStops
                                                        : kLowSteps;
          work.touched_steps.push_back({start, at, work.row(row + part)});
        });
      });
  if (hn::AllFalse(d, stopped.any())) {
    work.steps.size = size_before;
    work.steps.lanes = lanes_before;
    work.touched_steps.resize(touched_before);
    return;
  }
  work.stairs_views.push_back(stairs_view(scan, row, hn::GetLane(hn::MinOfLanes(d, stopped.first)),
                                          hn::GetLane(hn::MaxOfLanes(d, stopped.end))));
}

// Lists what those scans of a group see of a staircase that see stops.
HWY_INLINE void find_steps(const ScanStarts& starts, const ScanGroup& group, std::size_t number,
                           const PackedStairs& stairs, const BeamTable& beams, Workspace& work) {
  const Floats d;
  const Ints di;
  const std::size_t first_row = number * kBlock * kStairsRows;
  const LaserLanes lasers = lasers_of(starts, group);
  FloatMask real = hn::FirstN(d, group.count);
  StoppedRays stopped;
  work.make_stairs_rows(first_row + kBlock * kStairsRows);
  work.steps.make_room(2 * hn::Lanes(d) * group.cell->lanes);
  const auto list = [&](std::uint32_t begin, std::uint32_t end,
                        std::size_t part) MAPWRIGHT_INLINE_LAMBDA {
    const IntVector rows =
        hn::Add(hn::Load(di, work.stairs_rows.data()), hn::Set(di, work.row(first_row + part)));
    for_each_segment(*group.cell, {begin, end - begin}, lasers, real, beams,
                     [&](const LaneSpans& lanes, std::uint32_t lane) MAPWRIGHT_INLINE_LAMBDA {
                       append_spans(lanes, real, rows, beams, work.steps,
                                    [&](FloatMask seen, FloatVector from, FloatVector to)
                                        MAPWRIGHT_INLINE_LAMBDA {
                                          if (part == kStops) stopped.add(seen, from, to);
                                        });
                       const FloatMask touched = hn::And(lanes.near_line, real);
                       if (part == kStops) stopped.add_all(touched, beams);
                       for_rare_lanes(touched, [&](std::uint32_t i) {
                         const auto row = work.row(first_row + i * kStairsRows + part);
                         work.touched_steps.push_back({group.start(i), lane, row});
                       });
                     });
  };
  list(stairs.first_stop, stairs.lanes.first + stairs.lanes.count, kStops);
  real = hn::And(real, stopped.any());
  if (hn::AllFalse(d, real)) return;
  list(stairs.first_low_step, stairs.first_stop, kLowSteps);
  list(stairs.lanes.first, stairs.first_low_step, kTops);
  HWY_ALIGN float first[kBlock], end[kBlock];
  hn::Store(stopped.first, d, first);
  hn::Store(stopped.end, d, end);
  for (std::uint32_t bits = bits_of(real); bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(bits));
    work.stairs_views.push_back(stairs_view(i, first_row + i * kStairsRows, first[i], end[i]));
  }
}

// Report, figure 6: where the first segment met is a top, the staircase is crossed; elsewhere the
// nearest step higher than the laser stops the ray.
HWY_INLINE void combine_stairs(const StairsView& view, Workspace& work) {
  const Floats d;
  const float* const tops = work.stairs.data() + work.row(view.row + kTops);
  const float* const low_steps = work.stairs.data() + work.row(view.row + kLowSteps);
  const float* const stops = work.stairs.data() + work.row(view.row + kStops);
  float* const inverse = work.inverse(view.scan);
  for (std::int32_t i = view.first; i < view.end; i += kStep) {
    const FloatVector stop = hn::Load(d, stops + i);
    const FloatVector step = hn::Max(stop, hn::Load(d, low_steps + i));
    const FloatMask stopped = hn::Ge(step, hn::Load(d, tops + i));
    const FloatVector old = hn::Load(d, inverse + i);
    hn::Store(hn::Max(old, hn::IfThenElseZero(stopped, stop)), d, inverse + i);
  }
}

// Raises the buffers of the scans to what they see of staircases. Those of staircases matter only
// where stops are; elsewhere they hold anything.
HWY_NOINLINE void raise_stairs(const ScanSetup& setup, const ScanStarts& starts, Workspace& work) {
  for (const StairsView& view : work.stairs_views) {
    for (std::size_t part = 0; part < kStairsRows; ++part) {
      fill(work.stairs.data() + work.row(view.row + part) + view.first,
           static_cast<std::size_t>(view.end - view.first), 0.0F);
    }
  }
  raise_spans(*setup.beams, work.steps, work.stairs.data());
  raise_touched(setup, starts, work.touched_steps, work.stairs.data());
  for (const StairsView& view : work.stairs_views) combine_stairs(view, work);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
