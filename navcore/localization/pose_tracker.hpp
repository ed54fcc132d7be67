// Position tracking: a robot that has one place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/localization/beam_sampling.hpp"
#include "navcore/localization/kld_sampling.hpp"
#include "navcore/localization/particle_filter.hpp"
#include "navcore/localization/pose_belief.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// One look at a scan, blunter or sharper than others.
struct TrackingStage {
  std::size_t beams = 61;  ///< NL
  double sigma_m = 0.1;    ///< σm
  double evidence = 20.0;  ///< as in LookSettings
};

/// What drives a robot off its way unfelt: a random walk, whose variance grows with the way, so
/// that ten short movements blur as much as a long one of the same sum. A movement's way is its
/// metres and, for each radian of turns, turn_m more.
struct Diffusion {
  double sigma_m = 0.05, sigma_deg = 1.5;               ///< of a metre's way
  double turn_m = 1.0;                                  ///< metres a radian
  double least_sigma_m = 0.005, least_sigma_deg = 0.1;  ///< of any movement, standing still too
};

/// Metres driven and, for each radian that the robot has turned in the end, turn_m more.
double way_of(const OdometryStep& step, double turn_m);

struct TrackerSettings {
  /// Each stage draws its particles around what the stage before has found, the first around what
  /// odometry says; the last says how the scan is weighed in the end.
  std::vector<TrackingStage> stages;
  LikelihoodModel likelihood;  ///< but for σm
  OdometryNoise odometry;
  KldSettings kld;               ///< adaptive NP, from kld.least to `particles`
  std::size_t particles = 2000;  ///< at most
  Diffusion diffusion;           ///< beside the noise of odometry
  double max_range_m = 25.0, height_m = 0.5;
};

/// A particle filter for a robot that is at one place: where a scan is much sharper than odometry,
/// few of the particles that odometry puts out would survive it. So they are drawn anew where the
/// scan has shown them to be worth something, and weighed by prior × likelihood / density they were
/// drawn with: importance sampling in stages (adaptive importance sampling, population Monte Carlo:
/// Cappé, Guillin, Marin, Robert 2004), the prior being a normal distribution with a tail (as in
/// the Gaussian particle filter of Kotecha and Djurić 2003).
class PoseTracker {
 public:
  /// Keeps a reference to `weigher`.
  PoseTracker(const ScanWeigher& weigher, const TrackerSettings& settings, std::uint64_t seed);

  /// Goes on from these particles; they lie around one place.
  void start(const ParticleSet& particles);

  void move(const OdometryStep& step);

  /// `trust` in [0, 1]: share of the evidence that the scan is allowed, the less the worse the last
  /// ones have fitted. Requires particles and at least one stage.
  UpdateReport update(const RecordedScan& scan, double trust = 1.0);

  const ParticleSet& particles() const { return particles_; }
  std::size_t beams() const { return beams_; }  ///< of the last update's last stage

 private:
  std::size_t wanted_particles() const;
  PoseBelief prior() const;
  std::vector<double> draw(const PoseBelief& proposal, std::size_t count);
  void weigh(const TrackingStage& stage, const RecordedScan& scan, double trust,
             const PoseBelief& prior, std::vector<double>& log_weights);

  const ScanWeigher* weigher_;
  TrackerSettings settings_;
  std::uint64_t seed_;
  std::uint64_t epoch_ = 0;
  std::size_t beams_ = 0;
  std::vector<PoseBelief::Deviate> deviates_;  ///< dealt out in turn, again and again
  std::size_t next_ = 0;                       ///< of them
  ParticleSet particles_;
  double way_m_ = 0.0;  ///< since the last update, as in Diffusion
};

}  // namespace mapwright::navcore
