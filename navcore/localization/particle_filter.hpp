// Monte Carlo localization with a map, a laser, a compass and odometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navcore/free_space.hpp"
#include "navcore/localization/filter_settings.hpp"
#include "navcore/localization/particles.hpp"
#include "navcore/localization/pose_estimate.hpp"
#include "navcore/localization/scan_weigher.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

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
