// Private to this folder: lists the spans of a scan, or of several scans from one cell.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_SPANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_SPANS_INL
#undef MAPWRIGHT_ENGINE_SPANS_INL
#else
#define MAPWRIGHT_ENGINE_SPANS_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "navcore/engine/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::RebindToSigned<Floats>;
using IntVector = hn::Vec<Ints>;

// The positions of the bits of a byte, lowest first.
using BitPositions = std::array<std::array<std::uint8_t, 8>, 256>;

constexpr BitPositions bit_positions() {
  BitPositions all{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    std::size_t count = 0;
    for (std::uint8_t bit = 0; bit < 8; ++bit) {
      if ((byte >> bit & 1U) != 0) all[byte][count++] = bit;
    }
  }
  return all;
}

alignas(kLine) inline constexpr BitPositions kPositions = bit_positions();

// -- the list ----------------------------------------------------------------------------------

HWY_INLINE std::uint32_t bits_of(FloatMask mask) {
  const Floats d;
  std::uint8_t bytes[8];
  hn::StoreMaskBits(d, mask, bytes);
  if (hn::Lanes(d) <= 8) return bytes[0];
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

// The number of the first ray that is not to the right of the bearing, as a whole float plus 2²³,
// whose lowest bits are that number. Ends that segments share give the same number for both, and
// so no ray is between them.
constexpr float kWhole = 8388608.0F;
constexpr std::int32_t kWholeNumber = (1 << 23) - 1;

HWY_INLINE FloatVector ray_at(FloatVector bearing, FloatVector least, FloatVector most,
                              const BeamTable& beams) {
  const Floats d;
  const FloatVector ray =
      hn::MulAdd(bearing, hn::Set(d, beams.rays_per_radian), hn::Set(d, beams.half_past_middle));
  return hn::Add(hn::Min(hn::Max(ray, least), most), hn::Set(d, kWhole));
}

// Which rays a span has, for Raise: bits of the first two vectors, or the first ray.
HWY_INLINE IntVector which_rays(IntVector first, IntVector end, IntVector ray) {
#if HWY_TARGET <= HWY_AVX3
  const IntVector all = hn::Set(Ints(), -1);
  return hn::AndNot(hn::Shl(all, hn::Sub(end, ray)), hn::Shl(all, hn::Sub(first, ray)));
#else
  (void)end;
  (void)ray;
  return first;
#endif
}

#if HWY_TARGET <= HWY_AVX3
// Lists hold the lanes that have rays, and nothing else.
constexpr bool kListsAreDense = true;

template <class D, class V, class T>
HWY_INLINE void append(D d, V vector, hn::Mask<D> mask, std::size_t size, T* array) {
  hn::StoreU(hn::Compress(vector, mask), d, array + size);
}
HWY_INLINE void end_append(FloatMask mask, SpanList& list) {
  list.size += hn::CountTrue(Floats(), mask);
}
HWY_INLINE std::size_t append_at(const SpanList& list) {
  return list.size;
}
#else
// Lists hold whole vectors, and apart from them which lanes have rays. (Highway's Compress, of the
// version that Debian has, copies a table each time.)
constexpr bool kListsAreDense = false;

template <class D, class V, class T>
HWY_INLINE void append(D d, V vector, hn::Mask<D>, std::size_t lanes, T* array) {
  hn::Store(vector, d, array + lanes);
}
HWY_INLINE void end_append(FloatMask mask, SpanList& list) {
  const hn::CappedTag<std::int32_t, 8> di;
  const hn::Rebind<std::uint8_t, decltype(di)> bytes;
  const std::uint32_t bits = bits_of(mask);
  const auto numbers = hn::PromoteTo(di, hn::Load(bytes, kPositions[bits].data()));
  hn::StoreU(hn::Add(numbers, hn::Set(di, static_cast<std::int32_t>(list.lanes))), di,
             list.seen.data() + list.size);
  list.size += static_cast<std::size_t>(__builtin_popcount(bits));
  list.lanes += hn::Lanes(Floats());
}
HWY_INLINE std::size_t append_at(const SpanList& list) {
  return list.lanes;
}
#endif

// Appends those of the lanes' spans from … to that are `valid` and have rays. `row` is where the
// lanes' buffers are; calls note(lanes with rays, first, end), the rays as ray_at() has them.
// Requires room.
template <class Note>
HWY_INLINE void append_spans(const LaneSpans& lanes, FloatVector from, FloatVector to,
                             FloatMask valid, IntVector row, const BeamTable& beams, SpanList& list,
                             Note&& note) {
  const Floats d;
  const Ints di;
  const FloatVector none = hn::Zero(d);
  const FloatVector rays = hn::Set(d, static_cast<float>(beams.rays));
  const FloatVector whole_first = ray_at(from, none, rays, beams);
  const FloatVector whole_end = ray_at(to, none, rays, beams);
  const FloatMask seen = hn::And(valid, hn::Lt(whole_first, whole_end));
  note(seen, whole_first, whole_end);
  const IntVector number = hn::Set(di, kWholeNumber);
  const IntVector first = hn::And(hn::BitCast(di, whole_first), number);
  const IntVector end = hn::And(hn::BitCast(di, whole_end), number);
  const IntVector ray = hn::And(first, hn::Set(di, -static_cast<std::int32_t>(hn::Lanes(d))));
  const auto ints = hn::RebindMask(di, seen);
  const std::size_t i = append_at(list);
  append(d, lanes.cosine, seen, i, list.cosine.data());
  append(d, lanes.sine, seen, i, list.sine.data());
  append(di, ray, ints, i, list.ray.data());
  append(di, which_rays(first, end, ray), ints, i, list.which.data());
  append(di, end, ints, i, list.end.data());
  append(di, hn::Add(ray, row), ints, i, list.at.data());
  end_append(seen, list);
}

// Appends the lanes' spans; those that are seen at both ends of the field of view, around the back,
// twice. Requires room.
template <class Note>
HWY_INLINE void append_spans(const LaneSpans& lanes, FloatMask valid, IntVector row,
                             const BeamTable& beams, SpanList& list, Note&& note) {
  const Floats d;
  valid = hn::And(valid, lanes.valid);
  append_spans(lanes, lanes.from, lanes.to, valid, row, beams, list, note);
  const FloatMask twice = hn::And(valid, lanes.twice);
  if (HWY_LIKELY(hn::AllFalse(d, twice))) return;
  const FloatVector turn = hn::Set(d, kFullTurn);
  append_spans(lanes, hn::Add(lanes.from, turn), hn::Add(lanes.to, turn), twice, row, beams, list,
               note);
}

// For spans that nobody takes note of.
struct NoNote {
  HWY_INLINE void operator()(FloatMask, FloatVector, FloatVector) const {}
};

// Calls f(lane) for each lane of the mask, of which there rarely are any.
template <class F>
HWY_INLINE void for_rare_lanes(FloatMask mask, F&& f) {
  for (std::uint32_t bits = bits_of(mask); HWY_UNLIKELY(bits != 0); bits &= bits - 1) {
    f(static_cast<std::uint32_t>(__builtin_ctz(bits)));
  }
}

// -- one scan: a segment in each lane ----------------------------------------------------------

HWY_INLINE LaserLanes laser_of(const ScanStarts& starts, std::uint32_t start) {
  const Floats d;
  return {hn::Set(d, starts.x[start]), hn::Set(d, starts.y[start]),
          hn::Set(d, starts.cosine[start]), hn::Set(d, starts.sine[start])};
}

// Calls f(spans, first lane) for the blocks of a run of lanes.
template <class F>
HWY_INLINE void for_each_block(const PackedCell& cell, LaneRun run, const LaserLanes& laser,
                               const BeamTable& beams, F&& f) {
  const Floats d;
  const std::uint32_t step = static_cast<std::uint32_t>(hn::Lanes(d));
  for (std::uint32_t lane = run.first; lane < run.first + run.count; lane += step) {
    const float* const at = cell.block(lane) + lane % kBlock;
    const FloatVector x0 = hn::Load(d, at), y0 = hn::Load(d, at + kBlock);
    const FloatVector x1 = hn::Load(d, at + 2 * kBlock), y1 = hn::Load(d, at + 3 * kBlock);
    const EndLanes a(x0, y0, laser), b(x1, y1, laser);
    f(lane_spans({a, hn::Sub(x1, x0), hn::Sub(y1, y0), a.bearing(), b.bearing()}, laser, beams),
      lane);
  }
}

// Lists the walls and ramps that a scan may meet, for the buffer at `row`.
HWY_INLINE void find_walls(const ScanStarts& starts, const StartInCell& start, std::int32_t row,
                           const BeamTable& beams, Workspace& work) {
  const PackedCell& cell = *start.cell;
  const LaserLanes laser = laser_of(starts, start.start);
  const FloatMask all = hn::FirstN(Floats(), kBlock);
  work.walls.make_room(2 * cell.lanes);
  const auto append = [&](const LaneSpans& lanes, FloatMask valid,
                          std::uint32_t first_lane) MAPWRIGHT_INLINE_LAMBDA {
    append_spans(lanes, valid, hn::Set(Ints(), row), beams, work.walls, NoNote());
    for_rare_lanes(lanes.near_line, [&](std::uint32_t i) {
      work.touched_walls.push_back({start, first_lane + i, row});
    });
  };
  for_each_block(cell, cell.two_sided, laser, beams,
                 [&](const LaneSpans& lanes, std::uint32_t first_lane)
                     MAPWRIGHT_INLINE_LAMBDA { append(lanes, all, first_lane); });
  if (HWY_LIKELY(cell.one_sided.count == 0)) return;
  for_each_block(cell, cell.one_sided, laser, beams,
                 [&](const LaneSpans& lanes, std::uint32_t first_lane)
                     MAPWRIGHT_INLINE_LAMBDA { append(lanes, lanes.low_side, first_lane); });
}

// -- scans from one cell: a scan in each lane --------------------------------------------------

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

// Calls f(spans, lane) for those segments of a run that are not behind all of the `real` lanes. Of
// a chain every end is computed once.
template <class F>
HWY_INLINE void for_each_segment(const PackedCell& cell, LaneRun run, const LaserLanes& lasers,
                                 FloatMask real, const BeamTable& beams, F&& f) {
  const Floats d;
  if (run.count == 0) return;
  const float* at = cell.block(run.first);
  SharedEnd b(at[0], at[kBlock], lasers);
  for (std::uint32_t lane = run.first; lane < run.first + run.count; ++lane) {
    at = cell.block(lane) + lane % kBlock;
    const float x0 = at[0], y0 = at[kBlock], x1 = at[2 * kBlock], y1 = at[3 * kBlock];
    SharedEnd a = b.is_at(x0, y0) ? b : SharedEnd(x0, y0, lasers);
    b = SharedEnd(x1, y1, lasers);
    const FloatMask hidden = hn::And(a.is_behind, b.is_behind);
    if (beams.looks_ahead && hn::AllFalse(d, hn::AndNot(hidden, real))) continue;
    f(lane_spans({a.lanes, hn::Set(d, x1 - x0), hn::Set(d, y1 - y0), a.bearing(), b.bearing()},
                 lasers, beams),
      lane);
  }
}

// Lists the walls and ramps that scans of a group may meet.
HWY_INLINE void find_walls(const ScanStarts& starts, const ScanGroup& group, const BeamTable& beams,
                           Workspace& work) {
  const PackedCell& cell = *group.cell;
  const LaserLanes lasers = lasers_of(starts, group);
  const FloatMask real = hn::FirstN(Floats(), group.count);
  const IntVector rows = hn::Load(Ints(), work.rows.data());
  work.walls.make_room(2 * hn::Lanes(Floats()) * cell.lanes);
  const auto append = [&](const LaneSpans& lanes, FloatMask valid, std::uint32_t lane)
                          MAPWRIGHT_INLINE_LAMBDA {
                            append_spans(lanes, valid, rows, beams, work.walls, NoNote());
                            for_rare_lanes(hn::And(lanes.near_line, real), [&](std::uint32_t i) {
                              work.touched_walls.push_back({group.start(i), lane, work.row(i)});
                            });
                          };
  for_each_segment(cell, cell.two_sided, lasers, real, beams,
                   [&](const LaneSpans& lanes, std::uint32_t lane)
                       MAPWRIGHT_INLINE_LAMBDA { append(lanes, real, lane); });
  for_each_segment(cell, cell.one_sided, lasers, real, beams,
                   [&](const LaneSpans& lanes, std::uint32_t lane) MAPWRIGHT_INLINE_LAMBDA {
                     append(lanes, hn::And(real, lanes.low_side), lane);
                   });
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
