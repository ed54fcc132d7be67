// The best accuracy of one scan, place by place.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mapcore/progress.hpp"
#include "navcore/localizability/beam_noise.hpp"
#include "navcore/localizability/scan_information.hpp"

namespace mapwright::navcore {

/// The bound at one place and one heading of the robot.
struct HeadingAccuracy {
  double heading_deg = 0.0;  ///< of the robot, in [0, 360)
  AccuracyBound bound;       ///< Cramér-Rao: what no unbiased estimator beats
  /// The same with what the edges of things tell (edge_information.hpp): what a filter that knows
  /// its rough place gets.
  AccuracyBound with_edges;
};

/// The bound at a place over all headings of the robot.
struct PlaceAccuracy {
  HeadingAccuracy worst;         ///< the heading with the greatest `bound.major_m`
  HeadingAccuracy median;        ///< the heading in the middle of those, the better one of two
  HeadingAccuracy edges_worst;   ///< the same by `with_edges.major_m`
  HeadingAccuracy edges_median;  ///< the same by `with_edges.major_m`
};

struct AccuracySettings {
  LaserModel laser;
  LaserNoise noise;
  std::size_t headings = 16;          ///< evenly spread over the full turn from 0° on, >= 1
  std::optional<double> heading_deg;  ///< this heading only
};

/// Headings that are looked at, degrees. Those between are rounded to a beam of the scan, so that
/// one look around serves all of them; a laser whose steps are wider than 1/4 of the headings'
/// spacing keeps them as they are.
std::vector<double> headings_looked_at(const AccuracySettings& settings);

/// The accuracy at each of the places, from up to `threads` threads (0: one a core); the numbers
/// do not depend on how many.
std::vector<PlaceAccuracy> accuracy_at(const GradientCaster& caster, std::span<const Point> places,
                                       const AccuracySettings& settings, unsigned threads,
                                       const Progress& progress = {});

/// The accuracy of one scan.
HeadingAccuracy heading_accuracy(std::span<const RangeGradient> scan, const Pose& pose,
                                 const LaserModel& laser, const BeamNoise& noise);

}  // namespace mapwright::navcore
