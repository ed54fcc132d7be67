// Private to this folder: staircases, which a ray may cross, and what single precision leaves over.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_STAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_STAIRS_INL
#undef MAPWRIGHT_ENGINE_STAIRS_INL
#else
#define MAPWRIGHT_ENGINE_STAIRS_INL
#endif

#include <hwy/highway.h>

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

// Rows of a staircase.
enum StairsRow : std::size_t { kTops, kLowSteps, kStops, kStairsRows };

// Report, figure 6: where the first segment met is a top, the staircase is crossed; elsewhere the
// nearest step higher than the laser stops the ray.
HWY_INLINE void combine_stairs(const StairsView& view, Workspace& work) {
  const Floats d;
  const float* const tops = work.stairs.data() + work.row(view.row + kTops);
  const float* const low_steps = work.stairs.data() + work.row(view.row + kLowSteps);
  const float* const stops = work.stairs.data() + work.row(view.row + kStops);
  float* const inverse = work.inverse(view.scan);
  for (std::int32_t i = view.first & -kStep; i < view.end; i += kStep) {
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
    const std::int32_t first = view.first & -kStep;
    for (std::size_t part = 0; part < kStairsRows; ++part) {
      fill(work.stairs.data() + work.row(view.row + part) + first,
           static_cast<std::size_t>(view.end - first), 0.0F);
    }
  }
  raise_spans(*setup.beams, work.steps, work.stairs.data());
  raise_touched(setup, starts, work.touched_steps, work.stairs.data());
  for (const StairsView& view : work.stairs_views) combine_stairs(view, work);
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
