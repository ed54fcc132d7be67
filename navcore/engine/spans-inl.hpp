// Private to this folder: from segments to spans of rays.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_SPANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_SPANS_INL
#undef MAPWRIGHT_ENGINE_SPANS_INL
#else
#define MAPWRIGHT_ENGINE_SPANS_INL
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

#include "navcore/engine/bearing-inl.hpp"
#include "navcore/engine/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kBlock>;
using FloatVector = hn::Vec<Floats>;
using FloatMask = hn::Mask<Floats>;

// Segments whose line passes nearer than this (metres) are left to double precision.
constexpr float kNearLine_m = 1e-3F;

// A segment's interval of bearings reaches this far (radians) beyond its ends, so that rounding of
// bearings opens no gap and a ray through an end is stopped.
constexpr float kBearingSlack = 4e-7F;

constexpr float kFullTurn = 6.28318531F;

// What the lanes of a block become: coefficients of 1/r and the interval of bearings.
struct LaneSpans {
  FloatVector cosine, sine, from, to;
  FloatMask valid;      ///< well in range and clear of the laser
  FloatMask near_line;  ///< for double precision
  FloatMask low_side;   ///< the laser is on the left of a→b
  FloatMask twice;      ///< meets both ends of the field of view, around the back
};

// In the sensor frame a segment with direction e that starts at a lies at
// 1/r = (e_y cos φ − e_x sin φ) / (a × e).
HWY_INLINE LaneSpans lane_spans(const float* block, const ScanStart& start,
                                const BeamTable& beams) {
  const Floats d;
  const FloatVector x0 = hn::Load(d, block);
  const FloatVector y0 = hn::Load(d, block + kBlock);
  const FloatVector x1 = hn::Load(d, block + 2 * kBlock);
  const FloatVector y1 = hn::Load(d, block + 3 * kBlock);
  const FloatVector px = hn::Set(d, start.x);
  const FloatVector py = hn::Set(d, start.y);
  const FloatVector c = hn::Set(d, start.cosine);
  const FloatVector s = hn::Set(d, start.sine);
  const auto turned_x = [&](FloatVector x, FloatVector y)
                            HWY_ATTR { return hn::MulAdd(x, c, hn::Mul(y, s)); };
  const auto turned_y = [&](FloatVector x, FloatVector y)
                            HWY_ATTR { return hn::MulSub(y, c, hn::Mul(x, s)); };

  const FloatVector ax = hn::Sub(x0, px), ay = hn::Sub(y0, py);
  const FloatVector bx = hn::Sub(x1, px), by = hn::Sub(y1, py);
  const FloatVector ex = hn::Sub(x1, x0), ey = hn::Sub(y1, y0);
  const FloatVector area = hn::MulSub(ax, ey, hn::Mul(ay, ex));
  const FloatVector squared_area = hn::Mul(area, area);
  const FloatVector squared_length = hn::MulAdd(ex, ex, hn::Mul(ey, ey));

  const FloatVector at_a = bearing_of(d, turned_x(ax, ay), turned_y(ax, ay));
  const FloatVector at_b = bearing_of(d, turned_x(bx, by), turned_y(bx, by));
  const FloatMask a_is_right = hn::Gt(area, hn::Zero(d));
  const FloatVector right = hn::IfThenElse(a_is_right, at_a, at_b);
  const FloatVector left = hn::IfThenElse(a_is_right, at_b, at_a);
  // Segments span less than half a turn: a left end far to the right lies beyond the back.
  const FloatMask wraps = hn::Lt(hn::Sub(left, right), hn::Set(d, -1.0F));
  const FloatVector full_turn = hn::Set(d, kFullTurn);
  const FloatVector slack = hn::Set(d, kBearingSlack);
  const FloatVector from = hn::Sub(right, slack);
  const FloatVector to = hn::Add(hn::Add(left, slack), hn::IfThenElseZero(wraps, full_turn));
  // What reaches around the back as far as the field of view's other end is seen there; up to 180°
  // it is not seen at this end as well.
  const FloatVector half = hn::Set(d, beams.half_fov);
  const FloatMask around = hn::Ge(to, hn::Sub(full_turn, half));
  const FloatVector back = hn::IfThenElseZero(around, full_turn);

  const FloatVector per_area = reciprocal(d, area);
  const FloatMask clear =
      hn::Gt(squared_area, hn::Mul(squared_length, hn::Set(d, kNearLine_m * kNearLine_m)));
  const FloatMask in_range = hn::Le(
      squared_area, hn::Mul(squared_length, hn::Set(d, beams.max_range_m * beams.max_range_m)));
  return {hn::Mul(turned_y(ex, ey), per_area),
          hn::Neg(hn::Mul(turned_x(ex, ey), per_area)),
          hn::Sub(from, back),
          hn::Sub(to, back),
          hn::And(clear, in_range),
          hn::And(hn::Not(clear), hn::Gt(squared_length, hn::Zero(d))),
          a_is_right,
          hn::And(around, hn::Le(from, half))};
}

HWY_INLINE std::uint32_t bits_of(FloatMask mask) {
  const Floats d;
  std::uint8_t bytes[8];
  hn::StoreMaskBits(d, mask, bytes);
  if (hn::Lanes(d) <= 8) return bytes[0];
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

// Writes the spans of the lanes, turned left by `turn`; those of the `valid` ones that the field of
// view meets count.
HWY_INLINE void store_spans(const LaneSpans& lanes, FloatMask valid, float turn,
                            const BeamTable& beams, SpanBlock& block) {
  const Floats d;
  const FloatVector half = hn::Set(d, beams.half_fov);
  const FloatVector from = hn::Add(lanes.from, hn::Set(d, turn));
  const FloatVector to = hn::Add(lanes.to, hn::Set(d, turn));
  const FloatMask seen = hn::And(valid, hn::And(hn::Le(from, half), hn::Ge(to, hn::Neg(half))));
  // Rays to look at, a little generously: the bearings decide.
  const FloatVector scale = hn::Set(d, beams.rays_per_radian);
  const FloatVector margin = hn::Set(d, 0.01F);
  const FloatVector first = hn::Sub(hn::Mul(hn::Add(from, half), scale), margin);
  const FloatVector last = hn::Add(hn::Mul(hn::Add(to, half), scale), margin);
  const FloatVector last_ray = hn::Set(d, static_cast<float>(beams.rays - 1));
  hn::Store(lanes.cosine, d, block.cosine);
  hn::Store(lanes.sine, d, block.sine);
  hn::Store(from, d, block.from);
  hn::Store(to, d, block.to);
  hn::Store(hn::Max(first, hn::Zero(d)), d, block.first);
  hn::Store(hn::Min(last, last_ray), d, block.last);
  block.seen = bits_of(seen);
}

// Appends the spans of a run of lanes to the workspace, which must have room.
template <bool kOneSided>
HWY_INLINE void find_spans(const ScanStart& start, LaneRun run, const BeamTable& beams,
                           Workspace& work) {
  const Floats d;
  const std::uint32_t step = static_cast<std::uint32_t>(hn::Lanes(d));
  for (std::uint32_t i = 0; i < run.count; i += step) {
    const std::uint32_t lane = run.first + i;
    LaneSpans lanes = lane_spans(start.cell->block(lane) + lane % kBlock, start, beams);
    if (kOneSided) lanes.valid = hn::And(lanes.valid, lanes.low_side);
    SpanBlock& block = work.blocks[work.used];
    store_spans(lanes, lanes.valid, 0.0F, beams, block);
    block.near_line = bits_of(lanes.near_line);
    block.first_lane = lane;
    work.used += (block.seen | block.near_line) != 0 ? 1 : 0;
    const FloatMask twice = hn::And(lanes.valid, lanes.twice);
    if (HWY_UNLIKELY(!hn::AllFalse(d, twice))) {
      SpanBlock& second = work.blocks[work.used++];
      store_spans(lanes, twice, kFullTurn, beams, second);
      second.near_line = 0;
      second.first_lane = lane;
    }
  }
}

// Spans of everything a scan may meet: walls and ramps, then staircase by staircase.
HWY_INLINE void find_spans_of_scan(const ScanStart& start, const BeamTable& beams,
                                   Workspace& work) {
  const PackedCell& cell = *start.cell;
  work.make_room(2 * (cell.lanes / hn::Lanes(Floats()) + 1));
  find_spans<false>(start, cell.two_sided, beams, work);
  if (HWY_UNLIKELY(cell.one_sided.count != 0)) {
    find_spans<true>(start, cell.one_sided, beams, work);
  }
  work.end_section();
  for (const PackedStairs& stairs : cell.stairs()) {
    find_spans<false>(start, stairs.lanes, beams, work);
    work.end_section();
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
