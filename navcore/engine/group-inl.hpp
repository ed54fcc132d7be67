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

// Calls f(spans, segment) for those segments of a run that are not behind all of the `real` lanes.
// Of a chain every end is computed once.
template <class F>
HWY_INLINE void for_each_segment(const PackedCell& cell, SegmentRun run, std::uint32_t begin,
                                 std::uint32_t end, const LaserLanes& lasers, FloatMask real,
                                 const BeamTable& beams, F&& f) {
  const Floats d;
  if (begin == end) return;
  const float* const ax = cell.ends(run) - run.first;
  const float* const ay = ax + run.count;
  const float* const bx = ay + run.count;
  const float* const by = bx + run.count;
  SharedEnd b(ax[begin], ay[begin], lasers);
  for (std::uint32_t i = begin; i < end; ++i) {
    const float x0 = ax[i], y0 = ay[i], x1 = bx[i], y1 = by[i];
    SharedEnd a = b.is_at(x0, y0) ? b : SharedEnd(x0, y0, lasers);
    b = SharedEnd(x1, y1, lasers);
    const FloatMask hidden = hn::And(a.is_behind, b.is_behind);
    if (beams.looks_ahead && hn::AllFalse(d, hn::AndNot(hidden, real))) continue;
    f(lane_spans({a.lanes, hn::Set(d, x1 - x0), hn::Set(d, y1 - y0), a.bearing(), b.bearing()},
                 lasers, beams),
      i);
  }
}

template <class F>
HWY_INLINE void for_each_segment(const PackedCell& cell, SegmentRun run, const LaserLanes& lasers,
                                 FloatMask real, const BeamTable& beams, F&& f) {
  for_each_segment(cell, run, run.first, run.first + run.count, lasers, real, beams, f);
}

// Lists the walls and ramps that scans of a group may meet.
HWY_INLINE void find_walls(const ScanStarts& starts, const ScanGroup& group, const BeamTable& beams,
                           Workspace& work) {
  const PackedCell& cell = *group.cell;
  const LaserLanes lasers = lasers_of(starts, group);
  const FloatMask real = hn::FirstN(Floats(), group.count);
  const IntVector rows = hn::Load(Ints(), work.rows.data());
  work.walls.make_room(2 * hn::Lanes(Floats()) * cell.size);
  const auto append = [&](const LaneSpans& lanes, FloatMask valid, std::uint32_t segment)
                          MAPWRIGHT_INLINE_LAMBDA {
                            append_spans(lanes, valid, rows, beams, work.walls, NoNote());
                            for_rare_lanes(hn::And(lanes.near_line, real), [&](std::uint32_t i) {
                              work.touched_walls.push_back({group.start(i), segment, work.row(i)});
                            });
                          };
  for_each_segment(cell, cell.two_sided(), lasers, real, beams,
                   [&](const LaneSpans& lanes, std::uint32_t segment)
                       MAPWRIGHT_INLINE_LAMBDA { append(lanes, real, segment); });
  for_each_segment(cell, cell.one_sided(), lasers, real, beams,
                   [&](const LaneSpans& lanes, std::uint32_t segment) MAPWRIGHT_INLINE_LAMBDA {
                     append(lanes, hn::And(real, lanes.low_side), segment);
                   });
}

// -- staircases

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
  return {scan, row, static_cast<std::int32_t>(first - kWhole),
          static_cast<std::int32_t>(end - kWhole)};
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
  work.steps.make_room(2 * hn::Lanes(d) * group.cell->size);
  const auto list = [&](std::uint32_t begin, std::uint32_t end,
                        std::size_t part) MAPWRIGHT_INLINE_LAMBDA {
    const IntVector rows =
        hn::Add(hn::Load(di, work.stairs_rows.data()), hn::Set(di, work.row(first_row + part)));
    for_each_segment(*group.cell, stairs.segments, begin, end, lasers, real, beams,
                     [&](const LaneSpans& lanes, std::uint32_t segment) MAPWRIGHT_INLINE_LAMBDA {
                       append_spans(lanes, real, rows, beams, work.steps,
                                    [&](FloatMask seen, FloatVector from, FloatVector to)
                                        MAPWRIGHT_INLINE_LAMBDA {
                                          if (part == kStops) stopped.add(seen, from, to);
                                        });
                       const FloatMask touched = hn::And(lanes.near_line, real);
                       if (part == kStops) stopped.add_all(touched, beams);
                       for_rare_lanes(touched, [&](std::uint32_t i) {
                         const auto row = work.row(first_row + i * kStairsRows + part);
                         work.touched_steps.push_back({group.start(i), segment, row});
                       });
                     });
  };
  list(stairs.first_stop, stairs.segments.first + stairs.segments.count, kStops);
  real = hn::And(real, stopped.any());
  if (hn::AllFalse(d, real)) return;
  list(stairs.first_low_step, stairs.first_stop, kLowSteps);
  list(stairs.segments.first, stairs.first_low_step, kTops);
  HWY_ALIGN float first[kBlock], end[kBlock];
  hn::Store(stopped.first, d, first);
  hn::Store(stopped.end, d, end);
  for (std::uint32_t bits = bits_of(real); bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(bits));
    work.stairs_views.push_back(stairs_view(i, first_row + i * kStairsRows, first[i], end[i]));
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
