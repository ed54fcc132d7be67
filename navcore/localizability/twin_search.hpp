// For each place, the other place that a scan mistakes it for most easily.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mapcore/progress.hpp"
#include "navcore/engine/gradient_caster.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localizability/beam_noise.hpp"

namespace mapwright::navcore {

/// Poses further than this from each other (nats) are no twins: ρ = 2e−9.
inline constexpr double kMostTwinNats = 20.0;

/// What counts as another place, and what else the robot knows.
struct TwinSettings {
  LaserModel laser;
  LaserNoise noise{0.05, 0.1};
  double apart_m = 2.0;                               ///< nearer places are no confusion
  std::optional<double> compass_sigma_deg = 3;        ///< nothing: heading unknown
  std::vector<double> headings_deg{0, 90, 180, 270};  ///< of the robot, looked at
  std::size_t index_poses = 400'000;  ///< looked at for candidates, about: all over the map
  double robot_radius_m = 0.0;        ///< the robot must be able to stand at the other
};

/// Another pose whose scans are like those of a place.
struct Twin {
  Pose pose;
  double heading_deg = 0.0;  ///< of the robot at the place itself
  /// −ln of the Bhattacharyya coefficient of the two poses' scans, the compass included.
  double nats = 0.0;
};

/// The twins of one place, over the headings of the robot.
struct PlaceTwins {
  std::optional<Twin> worst;   ///< at the heading that is mistaken most
  std::optional<Twin> median;  ///< at the heading in the middle of those, the better one of two
};

/// −ln of the Bhattacharyya coefficient of the scans (and the compass readings) of two poses.
double distinction_nats(std::span<const RangeGradient> here, std::span<const RangeGradient> there,
                        const Pose& pose, const Pose& other, const TwinSettings& settings,
                        const BeamNoise& noise);

/// Places in columns and rows, where a robot can stand.
struct AskedPlaces {
  std::size_t columns = 0, rows = 0;
  std::vector<std::optional<Point>> places;  ///< row by row; nothing: not asked for
};

/// For each of the places, which are a few metres apart at most, the most confusing pose that was
/// found anywhere in the map for each heading; nothing where none is nearer than kMostTwinNats.
/// Headings at which the scan does not tell the position itself to a quarter of `apart_m` are
/// passed over: that it looks the same farther along a wall is a matter of accuracy.
///
/// Candidates are the poses whose scans have the most similar digest, on a grid over the map, and
/// what is a twin of a neighbouring place, moved along; each is moved to where its scan fits best
/// (Gauss-Newton, from a blunt to the true noise). Every twin proves its confusion; that none was
/// found proves nothing. The outcome does not depend on the number of threads.
std::vector<PlaceTwins> find_twins(const Map& map, const FreeSpace& space,
                                   const GradientCaster& caster, const AskedPlaces& asked,
                                   const TwinSettings& settings, unsigned threads,
                                   const Progress& progress = {});

/// The best fit to a scan from `pose` that Gauss-Newton reaches from `start`; nothing where, on the
/// way from a blunt likelihood to the laser's, too few beams agree for a twin.
std::optional<Pose> fitted(GradientCaster::Local& caster, std::span<const RangeGradient> scan,
                           const Pose& pose, Pose start, const TwinSettings& settings,
                           const BeamNoise& noise);

}  // namespace mapwright::navcore
