// Every tolerance of the project, in one place.
#pragma once

namespace mapwright::tolerance {

/// Grid the writer rounds coordinates and heights to, unless asked otherwise.
inline constexpr double kResolution_m = 0.001;

/// Greatest distance between a curve and the chords that stand for it (sagitta).
inline constexpr double kChordSagitta_m = 0.01;

/// Coordinates of two maps that differ by no more are the same: half a step of that grid.
inline constexpr double kSamePlace_m = 0.0005;

/// Ends nearer to each other than this were meant to be one point (snapping, near misses).
inline constexpr double kSnap_m = 0.01;

/// Coordinates beyond this are no local frame: somebody forgot to subtract the origin.
inline constexpr double kAbsurdCoordinate_m = 1.0e6;

/// Nothing a robot meets is higher.
inline constexpr double kAbsurdHeight_m = 1000.0;

/// A unit normal written with a few decimals is off by less than this.
inline constexpr double kUnitLength = 1.0e-3;

/// Obstacles that reach into each other by less than this only touch: rounding to the resolution
/// moves two outlines that far towards each other.
inline constexpr double kOverlapDepth_m = 0.002;

/// Steps lower or higher than this are typing errors, or no steps.
inline constexpr double kLeastStepRise_m = 0.02;
inline constexpr double kGreatestStepRise_m = 0.5;

/// Steps of a flight that turn more than this from one to the next are no flight (degrees). Winding
/// and fan stairs turn by less.
inline constexpr double kGreatestStepTurn_deg = 10.0;

/// Ramps steeper than this are walls or typing errors (degrees).
inline constexpr double kSteepRamp_deg = 20.0;

/// A robot stands beside an obstacle if there is at most this much room between them: nearer than
/// this "at the bench" means nothing.
inline constexpr double kBesidePlace_m = 1.0;

/// What a robot sent to an obstacle keeps away from it beyond its radius: more than the exact
/// planner's offset may lack.
inline constexpr double kStandoff_m = 0.005;

/// More than double arithmetic can be off by in a distance between points of a map. Proofs give it
/// away on the safe side.
inline constexpr double kArithmetic_m = 1.0e-9;

}  // namespace mapwright::tolerance
