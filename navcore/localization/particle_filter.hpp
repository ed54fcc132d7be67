// Monte Carlo localization with a map, a laser, a compass and odometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navcore/free_space.hpp"
#include "navcore/localization/kld_sampling.hpp"
#include "navcore/localization/likelihood.hpp"
#include "navcore/localization/particles.hpp"
#include "navcore/localization/pose_estimate.hpp"
#include "navcore/localization/scan_weigher.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// How a filter searches and tracks. `report_settings` and `robust_settings` give sets that belong
/// together; docs/localization.md says where the numbers come from.
struct FilterSettings {
  std::size_t particles = 6000;         ///< NP
  std::size_t first_particles = 50000;  ///< scored against the first scan when lost; >= particles
  LikelihoodModel likelihood;
  double temper = 1.0;  ///< τ: exponent of each scan's factor, in (0, 1]

  /// Once one mode has held this share of the weight for so many scans in a row, the filter is
  /// settled: it goes on with fewer particles and looks at each scan twice, first as above, then by
  /// degrees more sharply, until by this σm and τ. More than 1: never.
  double settled_share = 2.0;
  std::size_t settled_after = 3;
  std::size_t settled_particles = 1500;
  double settled_sigma_m = 0.06;
  double settled_temper = 0.6;
  std::size_t settled_stages = 3;

  double resample_below = 0.5;  ///< resample when the effective share falls below this

  /// The first scan of a lost robot is brought to bear in this many steps, from a blunt likelihood
  /// to the one above: σm falls from `first_sigma_m`, the exponent rises from near 0.
  std::size_t first_stages = 1;
  double first_sigma_m = 0.5;

  /// Between its stages the first particles are thinned out to this many times their effective
  /// number, but to no fewer than `particles`: a place that a few of them stand for is not left to
  /// chance. 0: to `particles` at once.
  double keep_effective = 0.0;

  /// Resampling gives a place (PlaceGrid, particles.hpp) that holds the share W of the weight
  /// particles in proportion to W to this power, and the particles the weight that makes up for it.
  /// 1: by weight alone. Less: a place that the scans speak against keeps some particles, with all
  /// that was ever seen in their weight, and comes back when later scans speak for it.
  double place_power = 1.0;

  /// Metropolis sweeps after each resampling and at each stage: every particle tries that many
  /// random moves and keeps those that the scan agrees with. Their lengths (standard deviations)
  /// are spread evenly over the orders of magnitude between these limits.
  std::size_t sweeps = 0;
  std::size_t first_sweeps = 0;  ///< the same at the first scan of a lost robot, if more
  double least_part =
      1.0 / 16.0;  ///< a scan is brought to bear in no smaller parts of its evidence
  double shortest_move_m = 0.04, longest_move_m = 0.8;
  double smallest_turn_deg = 0.2, largest_turn_deg = 4.0;

  /// The robot may be elsewhere than odometry says (kidnapped, or its place lost among the
  /// particles): with this probability before each later scan it is anywhere in free space, which
  /// so many extra particles stand for. When tracking from a known pose, only if free space is
  /// given.
  double elsewhere = 0.0;
  std::size_t elsewhere_particles = 0;
  double elsewhere_worth = 1e-3;  ///< they are dropped when the scan leaves them less weight

  /// Where the odometry itself may be wrong, a share of them stays near: a wheel that slipped, a
  /// turn that was not counted. Around the particles, by these standard deviations; with
  /// probability 1/2 at any heading.
  double nearby_share = 0.0;
  double nearby_m = 0.3;
  double nearby_deg = 15.0;

  std::optional<KldSettings> kld;  ///< adaptive NP, from kld->least to `particles`

  OdometryNoise odometry;
  unsigned threads = 1;  ///< 0: one a core
};

/// The report's filter: 6000 particles from the start, Eq. (4)-(6) to the letter.
FilterSettings report_settings();

/// The default: robust likelihood, dense and annealed first scan, resample-move.
FilterSettings robust_settings();

/// A compass reading and its standard deviation.
struct HeadingPrior {
  Angle heading;
  double sigma_deg = 0.0;
};

/// How a filter looks at scans from now on.
struct ScanLook {
  const ScanWeigher* weigher = nullptr;
  LaserModel laser;
  LikelihoodModel likelihood;
  double temper = 1.0;     ///< τ
  double elsewhere = 0.0;  ///< as in FilterSettings
  std::size_t elsewhere_particles = 0;
  std::size_t least_particles = 1;
  double nearby_share = 0.0;  ///< as in FilterSettings
};

/// What an update did.
struct UpdateReport {
  std::size_t particles = 0;         ///< that were scored
  double effective_particles = 0.0;  ///< the whole scan's weights leave, unresampled
  bool contradicted = false;         ///< the scan was impossible at each particle; weights kept
  bool resampled = false;
};

/// Particle filter (report, section 4.1, figure 4). The same settings, seed and inputs give the
/// same particles for any number of threads: every particle draws from a stream of its own.
class ParticleFilter {
 public:
  /// Keeps a reference to `weigher`, which must outlive the filter.
  ParticleFilter(const ScanWeigher& weigher, const LaserModel& laser,
                 const FilterSettings& settings, std::uint64_t seed);

  /// Anywhere in free space, heading uniform or near the compass reading. False if there is no free
  /// space. The filter keeps a reference to `space`: particles do not move into solids.
  bool start_anywhere(const FreeSpace& space, const std::optional<HeadingPrior>& heading);

  /// Near a pose: position tracking. Gaussian with these standard deviations. With `space` (kept,
  /// as above) the robot may turn out to be elsewhere.
  void start_at(const Pose& pose, double sigma_m, double sigma_deg,
                const FreeSpace* space = nullptr);

  /// From the next scan on (adaptive NL and NP). `look.weigher` must outlive the filter.
  void use(const ScanLook& look);

  /// Goes on from these particles, which something else has found. `space` as in start_at.
  void take(ParticleSet particles, const FreeSpace* space);

  /// The robot moved; encoders say how.
  void move(const OdometryStep& step);

  /// The robot took a scan of laser.rays ranges.
  UpdateReport update(std::span<const double> scan);

  const ParticleSet& particles() const { return particles_; }
  PoseEstimate estimate() const { return estimate_pose(particles_); }

 private:
  /// What the particles are to be distributed by: the prior × exp(exponent × log factor).
  struct Target {
    LikelihoodModel likelihood;
    double exponent = 1.0;
  };
  Target search_target(std::size_t stage) const;
  Target settled_target(std::size_t stage) const;
  void sharpen(std::span<const double> scan, UpdateReport& report);
  void search(std::span<const double> scan, UpdateReport& report);
  void bring_to_bear(const Target& target, double last, std::span<const double> scan,
                     UpdateReport& report);
  void track(std::span<const double> scan, UpdateReport& report);
  void add_elsewhere();
  void drop_elsewhere();
  Pose somewhere_near(Random& random) const;
  std::size_t wanted_particles(Random& random) const;
  double effective_size_after(double exponent) const;
  double bearable_part(double rest, double whole) const;
  void renew(const Target& target, std::span<const double> scan, UpdateReport& report);
  std::vector<double> weigh(const Target& target, std::span<const double> scan,
                            std::span<const Pose> poses) const;
  void resample();
  void sweep(const Target& target, std::span<const double> scan);
  Pose proposal(const Pose& pose, Random& random) const;
  Pose kin_proposal(std::size_t particle, Random& random) const;
  Random stream(std::size_t particle) const;

  const ScanWeigher* weigher_;
  const FreeSpace* space_ = nullptr;
  LaserModel laser_;
  FilterSettings settings_;
  std::uint64_t seed_;
  std::size_t size_limit_;               ///< particles after the next resampling
  std::uint64_t epoch_ = 0;              ///< counts the operations that draw random numbers
  std::optional<HeadingPrior> heading_;  ///< what compass and odometry say
  std::size_t sure_for_ = 0;             ///< scans in a row that one mode held enough weight
  bool sharp_ = false;                   ///< looks sharply
  bool lost_ = false;                    ///< started anywhere and not yet seen a scan
  std::size_t extras_ = 0;               ///< of the particles, at their end: elsewhere
  ParticleSet particles_;
  std::vector<IndexRange> kin_;  ///< per particle: those of its cell at the last resampling
  std::vector<double> factors_;  ///< per particle: log factor of the current scan
};

}  // namespace mapwright::navcore
