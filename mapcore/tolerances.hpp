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

/// Treads shorter or longer than this (along the way up) are typing errors, or two flights drawn as
/// one; what is longer than a stride is a landing and no part of the flight's rhythm.
inline constexpr double kLeastStepTread_m = 0.1;
inline constexpr double kGreatestStepTread_m = 5.0;
inline constexpr double kLanding_m = 0.8;

/// Rises and treads of one flight that differ by more than this from its usual ones are slips of
/// the pen: building codes allow about 1 cm, surveys are coarser.
inline constexpr double kRiseVariation_m = 0.05;
inline constexpr double kTreadVariation_m = 0.12;

/// Nobody passes on steps narrower than this; a step many times as wide as its neighbour belongs to
/// other stairs.
inline constexpr double kLeastStepWidth_m = 0.4;
inline constexpr double kGreatestStepWidthRatio = 2.0;

/// Rises of ramps: lower ones are no ramps, higher ones have a wrong normal.
inline constexpr double kLeastRampRise_m = 0.02;
inline constexpr double kGreatestRampRise_m = 10.0;

/// Outlines thinner than this, and corners that run out and back within it, are slips of the pen.
inline constexpr double kSliverWidth_m = 0.01;

/// A border farther from all obstacles than this, and farther than they reach themselves, was not
/// meant.
inline constexpr double kBorderMargin_m = 100.0;

/// A border nearer than this to solids on all sides leaves no way round them.
inline constexpr double kTightBorder_m = 0.01;

/// Few obstacles are higher than this: where a hundredth or a thousandth of a height is usual in
/// the map, it is suspected to be in other units.
inline constexpr double kSuspectHeight_m = 50.0;

/// Height of the laser above the ground, unless a robot is described.
inline constexpr double kLaserHeight_m = 0.5;

/// Lower things a wheeled robot rolls over.
inline constexpr double kGroundClearance_m = 0.02;

/// Two ways from a map's point to the Earth that differ by more than this are two frames.
inline constexpr double kFrameAgreement_m = 0.01;

/// Beyond this distance from the origin a plane is no picture of the Earth: at 30 km lengths of
/// transverse Mercator grow by 1e-5.
inline constexpr double kFarFromOrigin_m = 30.0e3;

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
