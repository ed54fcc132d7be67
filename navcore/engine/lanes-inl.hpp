// Private to this folder: from segments to spans of rays, lane by lane.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_LANES_INL
#undef MAPWRIGHT_ENGINE_LANES_INL
#else
#define MAPWRIGHT_ENGINE_LANES_INL
#endif

#include <hwy/highway.h>

#include "navcore/engine/bearing-inl.hpp"
#include "navcore/engine/kernels.hpp"

// For lambdas in inner loops: a call would pass dozens of vectors through memory.
#ifndef MAPWRIGHT_INLINE_LAMBDA
#define MAPWRIGHT_INLINE_LAMBDA HWY_ATTR __attribute__((always_inline))
#endif

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

// Lasers, relative to the cell's centre: the same in all lanes, or one in each.
struct LaserLanes {
  FloatVector x, y, cosine, sine;

  HWY_INLINE FloatVector ahead(FloatVector dx, FloatVector dy) const {
    return hn::MulAdd(dx, cosine, hn::Mul(dy, sine));
  }
  HWY_INLINE FloatVector left(FloatVector dx, FloatVector dy) const {
    return hn::MulSub(dy, cosine, hn::Mul(dx, sine));
  }
};

// Ends of segments as the lasers see them.
struct EndLanes {
  HWY_INLINE EndLanes(FloatVector x, FloatVector y, const LaserLanes& laser)
      : dx(hn::Sub(x, laser.x)),
        dy(hn::Sub(y, laser.y)),
        ahead(laser.ahead(dx, dy)),
        left(laser.left(dx, dy)) {}

  HWY_INLINE FloatVector bearing() const { return bearing_of(Floats(), ahead, left); }

  FloatVector dx, dy;       ///< from the laser, along the map's axes
  FloatVector ahead, left;  ///< along the sensor's
};

// Segments from a to b.
struct SegmentLanes {
  const EndLanes& a;
  FloatVector ex, ey;      ///< b − a along the map's axes
  FloatVector at_a, at_b;  ///< bearings of the ends
};

// What the lanes become: coefficients of 1/r and the interval of bearings, which reaches a little
// beyond the ends.
struct LaneSpans {
  FloatVector cosine, sine, from, to;
  FloatMask valid;      ///< well in range and clear of the laser
  FloatMask near_line;  ///< for double precision
  FloatMask low_side;   ///< the laser is on the left of a→b
  FloatMask twice;      ///< meets both ends of the field of view, around the back
};

// In the sensor frame a segment with direction e that starts at a lies at
// 1/r = (e_y cos φ − e_x sin φ) / (a × e).
HWY_INLINE LaneSpans lane_spans(const SegmentLanes& segment, const LaserLanes& laser,
                                const BeamTable& beams) {
  const Floats d;
  const FloatVector ex = segment.ex, ey = segment.ey;
  const FloatVector area = hn::MulSub(segment.a.dx, ey, hn::Mul(segment.a.dy, ex));
  const FloatVector squared_area = hn::Mul(area, area);
  const FloatVector squared_length = hn::MulAdd(ex, ex, hn::Mul(ey, ey));

  const FloatMask a_is_right = hn::Gt(area, hn::Zero(d));
  const FloatVector right = hn::IfThenElse(a_is_right, segment.at_a, segment.at_b);
  const FloatVector left = hn::IfThenElse(a_is_right, segment.at_b, segment.at_a);
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
  return {hn::Mul(laser.left(ex, ey), per_area),
          hn::Neg(hn::Mul(laser.ahead(ex, ey), per_area)),
          hn::Sub(from, back),
          hn::Sub(to, back),
          hn::And(clear, in_range),
          hn::And(hn::Not(clear), hn::Gt(squared_length, hn::Zero(d))),
          a_is_right,
          hn::And(around, hn::Le(from, half))};
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
