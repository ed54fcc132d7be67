// A flight of stairs as the report draws it: steps of growing or falling height and a closing
// segment.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// The segments of an obstacle of shape type 5, sorted into steps and closing segments. Segments of
/// no length are left out (G103 tells of them).
struct Flight {
  std::vector<std::size_t> steps;    ///< segments higher than 0, as they are printed
  std::vector<std::size_t> closing;  ///< segments of height 0, as they are printed
  bool rises = true;                 ///< most steps are higher than the one printed before them
  std::optional<std::size_t> top;    ///< the closing segment beside the highest step
  /// Per step: true if it faces as most steps do, each compared with the step before it.
  std::vector<bool> faces_as_most;
};

/// Both orders are understood: from the foot up with the closing segment last (the report's prose),
/// and from the top down with the closing segment first (its printed sample).
Flight flight_of(const Obstacle& stairs);

/// True for pieces of one riser (a bent one, or one of a fan of steps) that stand beside each
/// other, not one behind the other: seen along the first, the second covers less than half of the
/// shorter one.
bool stand_side_by_side(const Segment& p, const Segment& q);

/// One step of a flight: mostly a segment, where it is bent or interrupted several of one height.
struct Riser {
  std::vector<std::size_t> pieces;  ///< positions of its segments
  double height_m = 0.0;            ///< above the foot of the stairs
  double width_m = 0.0;             ///< length of all pieces
};

/// The risers, from the foot up.
std::vector<Riser> risers_of(const Obstacle& stairs, const Flight& flight);

/// How far the middle of one step lies behind another, across that one; metres, positive.
double tread_m(const Segment& lower, const Segment& upper);

/// How far p lies behind a step: positive above it, where its left is (the free, lower side of a
/// step is its right); negative in front of it.
double behind_m(const Segment& step, Point p);

/// How far one riser lies behind another, across the lower one's first piece; metres, positive.
double tread_m(const Obstacle& stairs, const Riser& lower, const Riser& upper);

/// True if each riser is higher than the one below it, by a rise within the limits: only then do
/// finer questions about the flight make sense.
bool rises_plausibly(const std::vector<Riser>& risers, double min_rise_m, double max_rise_m);

/// The middle one of some values, of an even number the upper of both; requires at least one.
double median(std::vector<double> values);

}  // namespace mapwright::validators
