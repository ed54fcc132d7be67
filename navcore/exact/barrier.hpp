// Proof that two places are not connected.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navcore/exact/grid_point.hpp"
#include "navcore/exact/line_work.hpp"
#include "navcore/exact/tessellation.hpp"

namespace mapwright::navcore::exact {

/// A straight part of a barrier: along a line, or across the gap between two.
struct BarrierLeg {
  GridPoint from, to;
  std::uint32_t line_from = 0, line_to = 0;  ///< of Barrier::lines; equal for a part along a line

  bool is_gap() const { return line_from != line_to; }
};

/// A closed polygon that a disc cannot cross: it runs along obstacles, and over gaps that are too
/// narrow.
struct Barrier {
  std::vector<BarrierLeg> legs;
  std::vector<Line> lines;  ///< what it runs along; Line::source as the map's lines have it
};

/// Checks a barrier with integers only, trusting nothing that made it: true if
/// - each leg begins where the last one ends, and the last one ends where the first begins;
/// - a leg along a line is nearer to it than the radius at both ends, so everywhere (for radius 0:
///   on it);
/// - a leg across a gap has one end on its line, and the other line is nearer to that end than the
///   disc's diameter (the square of this distance is a rational number and is compared exactly), so
///   each point of the straight way across is nearer to one of them than the radius. The leg's
///   other end is the foot of that way, rounded to the grid; start and goal are 2 mm or more from
///   the leg, so that rounding does not change on which side they are. Discs of 2 mm and less pass
///   every gap; and
/// - its winding numbers around start and goal differ, neither of which lies on it.
/// A disc of `radius_nm` (nanometres, rounded down) whose way from start to goal crosses the
/// polygon overlaps one of the lines.
bool separates(const Barrier& barrier, GridPoint start, GridPoint goal, std::int64_t radius_nm);

/// A way off from a place, in grid units of any length.
struct Direction {
  std::int64_t x = 0, y = 0;
};

/// Start or goal. In closed free space it may lie on an outline, and so on the barrier itself: what
/// counts then is on which sides of the barrier the free space begins there.
struct BarrierEnd {
  GridPoint at;
  /// Into each part of the free space that a small disc around `at` is cut into by the lines there;
  /// empty for a place on no line.
  std::vector<Direction> ways_off;
};

/// `separates` for places of which some lie on lines: the winding numbers around all points just
/// off the one, along its `ways_off`, differ from those of the other. Such points are shifted by so
/// little that no line comes between (integers of 256 bits). Requires a point robot where there are
/// `ways_off`.
bool separates_ways_off(const Barrier& barrier, const BarrierEnd& start, const BarrierEnd& goal,
                        std::int64_t radius_nm);

/// The shortest barrier between start and goal that passes `separates_ways_off`, among those that
/// run around a free region of `space`. Nothing where none is confirmed.
///
/// `base` is the free space of a point; the lines of `space` have the edges of `base` they keep
/// away from as source (offset_free_space). For a point robot both are the same object.
std::optional<Barrier> find_barrier(const Tessellation& base, const Tessellation& space,
                                    const BarrierEnd& start, const BarrierEnd& goal,
                                    std::int64_t radius_nm);

}  // namespace mapwright::navcore::exact
