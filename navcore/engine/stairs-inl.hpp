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
#include <cstddef>
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
    cast_at_item(*setup.scene, item.scan.cell->item(item.segment), setup.height_m, *setup.beams,
                 pose, buffers + item.row);
  }
}

// Raises the buffers to what was found.
HWY_INLINE void raise_found(const ScanSetup& setup, const ScanStarts& starts,
                            const FoundSpans& found, float* buffers) {
  raise_spans(*setup.beams, found.spans, buffers);
  raise_touched(setup, starts, found.touched, buffers);
}

// -- lone staircases ---------------------------------------------------------------------------

// Marks rays that cross tops in double precision.
HWY_NOINLINE void cross_touched(const ScanSetup& setup, const ScanStarts& starts, Workspace& work) {
  const Floats d;
  const BeamTable& beams = *setup.beams;
  const Cross cross{beams.out_of_range};
  AlignedFloats tops(beams.padded_rays());
  for (TouchedItem item : work.lone_tops.touched) {
    float* const inverse = work.inverses.data() + item.row;
    item.row = 0;
    std::fill(tops.begin(), tops.end(), 0.0F);
    raise_touched(setup, starts, {&item, 1}, tops.data());
    for (std::size_t i = 0; i < beams.padded_rays(); i += hn::Lanes(d)) {
      const FloatVector top = hn::Load(d, tops.data() + i);
      hn::Store(cross(hn::Load(d, inverse + i), hn::FirstN(d, hn::Lanes(d)), top), d, inverse + i);
    }
  }
}

// Report, figure 6: where the first segment met is a top, the staircase is crossed. So tops take
// back what stops behind them did, and the scan's own buffer has to be free of anything else.
HWY_INLINE void raise_lone_stairs(const ScanSetup& setup, const ScanStarts& starts,
                                  Workspace& work) {
  const BeamTable& beams = *setup.beams;
  float* const inverses = work.inverses.data();
  raise_found(setup, starts, work.lone_stops, inverses);
  raise_spans(beams, work.lone_tops.spans, inverses, Cross{beams.out_of_range});
  if (HWY_UNLIKELY(!work.lone_tops.touched.empty())) cross_touched(setup, starts, work);
}

// -- others ------------------------------------------------------------------------------------

// Rows of a staircase.
enum StairsRow : std::size_t { kTops, kLowSteps, kStops, kStairsRows };

// Report, figure 6: where the first segment met is a top, the staircase is crossed; elsewhere the
// nearest step higher than the laser stops the ray.
HWY_INLINE void combine_stairs(const StairsView& view, std::size_t rays, Workspace& work) {
  const Floats d;
  const float* const tops = work.stairs.data() + work.row(view.row + kTops);
  const float* const low_steps = work.stairs.data() + work.row(view.row + kLowSteps);
  const float* const stops = work.stairs.data() + work.row(view.row + kStops);
  float* const inverse = work.inverse(view.scan);
  for (std::size_t i = 0; i < rays; i += hn::Lanes(d)) {
    const FloatVector stop = hn::Load(d, stops + i);
    const FloatVector step = hn::Max(stop, hn::Load(d, low_steps + i));
    const FloatMask stopped = hn::Ge(step, hn::Load(d, tops + i));
    const FloatVector old = hn::Load(d, inverse + i);
    hn::Store(hn::Max(old, hn::IfThenElseZero(stopped, stop)), d, inverse + i);
  }
}

// Raises the buffers of the scans to what they see of staircases that have rows of their own.
HWY_NOINLINE void raise_stairs(const ScanSetup& setup, const ScanStarts& starts, Workspace& work) {
  const BeamTable& beams = *setup.beams;
  for (const StairsView& view : work.stairs_views) {
    fill(work.stairs.data() + work.row(view.row), kStairsRows * beams.padded_rays(), 0.0F);
  }
  raise_found(setup, starts, work.steps, work.stairs.data());
  for (const StairsView& view : work.stairs_views) combine_stairs(view, beams.rays, work);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
