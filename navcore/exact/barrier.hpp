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
/// - the ends of a leg across a gap are within 1 mm of their lines and the leg is shorter than the
///   disc's diameter less 2 mm, so that each of its points is nearer to a line than the radius; and
/// - its winding numbers around start and goal differ, neither of which lies on it.
/// A disc of `radius_mm` (rounded down) whose way from start to goal crosses the polygon overlaps
/// one of the lines.
bool separates(const Barrier& barrier, GridPoint start, GridPoint goal, std::int64_t radius_mm);

/// The shortest barrier between start and goal that `separates` confirms, among those that run
/// around a free region of `space`. Nothing where none is confirmed.
///
/// `base` is the free space of a point; the lines of `space` have the edges of `base` they keep
/// away from as source (offset_free_space). For a point robot both are the same object.
std::optional<Barrier> find_barrier(const Tessellation& base, const Tessellation& space,
                                    GridPoint start, GridPoint goal, std::int64_t radius_mm);

}  // namespace mapwright::navcore::exact
