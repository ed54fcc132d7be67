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
#include <cstdint>

#include "navcore/engine/alone-inl.hpp"
#include "navcore/engine/group-inl.hpp"
#include "navcore/engine/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// -- scans -------------------------------------------------------------------------------------

// Calls `finish(scans)`, whose spans are in the workspace.
template <class Finish>
HWY_INLINE void cast_listed(const ScanSetup& setup, const ScanStarts& starts, ScansTogether scans,
                            Workspace& work, Finish&& finish) {
  raise_lone_stairs(setup, starts, work);
  raise_found(setup, starts, work.walls, work.inverses.data());
  if (!work.stairs_views.empty()) raise_stairs(setup, starts, work);
  finish(scans);
}

// Calls `finish(scans)` for the scans that are alone. They go through each stage together: the
// processor works on several of them at once as long as no branch hangs on what a single one sees.
template <class Finish>
HWY_INLINE void for_each_alone(const ScanSetup& setup, const ScanStarts& starts, Workspace& work,
                               Finish&& finish) {
  const ScansTogether alone = starts.alone;
  for (std::size_t begin = 0; begin < alone.size(); begin += kTogether) {
    const std::size_t end = std::min(alone.size(), begin + kTogether);
    const std::size_t ahead = std::min(alone.size(), end + kTogether);
    const ScansTogether scans = alone.subspan(begin, end - begin);
    work.clear();
    const LaserTable lasers(starts, begin, setup.behind_m);
    find_all(setup, scans, alone.subspan(end, ahead - end), lasers, work);
    cast_listed(setup, starts, scans, work, finish);
  }
}

// Calls `finish(scans)` for the scans of the group.
template <class Finish>
HWY_INLINE void for_each_of_group(const ScanSetup& setup, const ScanStarts& starts,
                                  const ScanGroup& group, Workspace& work, Finish&& finish) {
  work.clear();
  find_all(starts, group, *setup.beams, work);
  StartInCell scans[kBlock];
  for (std::uint32_t i = 0; i < group.count; ++i) {
    scans[i] = group.start(i);
    clear_inverse(*setup.beams, work.inverse(i));
  }
  cast_listed(setup, starts, {scans, group.count}, work, finish);
}

// Fewer scans from one cell are cast alone: lanes of a group that stay empty cost as much as
// others. Where that turns was measured.
GroupSize group_size(const BeamTable& beams) {
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(Floats()));
  // The buffers of a group should fit into the first-level cache.
  constexpr std::size_t kBufferBytes = 32768;
  const bool fits = lanes * beams.padded_rays() * sizeof(float) <= kBufferBytes;
  return {fits ? std::max(4U, lanes * 3 / 8) : lanes, lanes};
}

// Calls `finish(scans)` for all scans, up to a block at a time; the order is open.
template <class Finish>
HWY_INLINE void cast_together(const ScanSetup& setup, const ScanStarts& starts, Workspace& work,
                              Finish&& finish) {
  const auto most = static_cast<std::uint32_t>(hn::Lanes(Floats()));
  for (const ScanStarts::InCell& same : starts.groups) {
    for (std::uint32_t done = 0; done < same.count; done += most) {
      const ScanGroup group{same.cell, same.first + done, std::min(same.count - done, most)};
      for_each_of_group(setup, starts, group, work, finish);
    }
  }
  for_each_alone(setup, starts, work, finish);
}

// -- ranges ------------------------------------------------------------------------------------

// Ranges from inverse ranges.
HWY_INLINE FloatVector ranges_of(const BeamTable& beams, FloatVector inverse) {
  const Floats d;
  return hn::Min(reciprocal(d, inverse), hn::Set(d, beams.max_range_m));
}

// Writes the ranges of a scan. The last vector overlaps the one before.
HWY_INLINE void store_ranges(const BeamTable& beams, const float* inverse, float* out) {
  const Floats d;
  const std::size_t step = hn::Lanes(d);
  if (HWY_UNLIKELY(beams.rays < step)) {
    HWY_ALIGN float few[kBlock];
    hn::Store(ranges_of(beams, hn::Load(d, inverse)), d, few);
    std::copy_n(few, beams.rays, out);
    return;
  }
  hn::StoreU(ranges_of(beams, hn::Load(d, inverse)), d, out);
  const std::size_t last = beams.rays - step;
  const std::size_t misaligned = reinterpret_cast<std::uintptr_t>(out) / sizeof(float) % step;
  for (std::size_t i = step - misaligned; i < last; i += step) {
    hn::Store(ranges_of(beams, hn::LoadU(d, inverse + i)), d, out + i);
  }
  hn::StoreU(ranges_of(beams, hn::LoadU(d, inverse + last)), d, out + last);
}

void cast_scans(const ScanSetup& setup, const ScanStarts& starts, Workspace& work, float* ranges) {
  const BeamTable& beams = *setup.beams;
  cast_together(setup, starts, work, [&](ScansTogether scans) HWY_ATTR {
    for (std::size_t i = 0; i < scans.size(); ++i) {
      store_ranges(beams, work.inverse(i), ranges + starts.scan[scans[i].start] * beams.rays);
    }
  });
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
