// Monte Carlo localization with a map, a laser, a compass and odometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navcore/free_space.hpp"
#include "navcore/localization/filter_settings.hpp"
#include "navcore/localization/heading_prior.hpp"
#include "navcore/localization/particles.hpp"
#include "navcore/localization/pose_filter.hpp"
#include "navcore/localization/scan_weigher.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

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

/// Particle filter (report, section 4.1, figure 4). The same settings, seed and inputs give the
/// same particles for any number of threads: every particle draws from a stream of its own.
class ParticleFilter final : public PoseFilter {
 public:
  /// Keeps a reference to `weigher`, which must outlive the filter.
  ParticleFilter(const ScanWeigher& weigher, const LaserModel& laser,
                 const FilterSettings& settings, std::uint64_t seed);

  /// As in PoseFilter: particles do not move into solids.
  bool start_anywhere(const FreeSpace& space, const std::optional<HeadingPrior>& heading) override;

  void start_at(const Pose& pose, double sigma_m, double sigma_deg,
                const FreeSpace* space = nullptr) override;

  /// From the next scan on (adaptive NL and NP). `look.weigher` must outlive the filter.
  void use(const ScanLook& look);

  /// Goes on from these particles, which something else has found. `space` as in start_at.
  void take(ParticleSet particles, const FreeSpace* space);

  void move(const OdometryStep& step) override;
  UpdateReport update(std::span<const double> scan) override;
  const ParticleSet& particles() const override { return particles_; }

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
