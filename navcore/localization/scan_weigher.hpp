// Scores many poses against one perceived scan.
#pragma once

#include <span>

#include "mapcore/angle.hpp"
#include "navcore/localization/likelihood.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

/// The costly part of a particle filter in one call for all particles, so that an engine that casts
/// and weighs in one pass can take its place. Safe to use from many threads.
class ScanWeigher {
 public:
  virtual ~ScanWeigher() = default;

  /// `log_weight_factor` of the scan at each pose (likelihood.hpp). `scan` holds laser.rays ranges;
  /// log_factors.size() == poses.size(). Uses up to `threads` threads (0: one a core); the numbers
  /// do not depend on how many.
  virtual void weigh(std::span<const double> scan, const LaserModel& laser,
                     const LikelihoodModel& likelihood, std::span<const Pose> poses,
                     std::span<double> log_factors, unsigned threads) const = 0;
};

/// Casts a synthetic scan from each pose with any ray caster, which must outlive it.
class RayCastingWeigher : public ScanWeigher {
 public:
  explicit RayCastingWeigher(const RayCaster& caster) : caster_(&caster) {}

  void weigh(std::span<const double> scan, const LaserModel& laser,
             const LikelihoodModel& likelihood, std::span<const Pose> poses,
             std::span<double> log_factors, unsigned threads) const override;

 private:
  const RayCaster* caster_;
};

}  // namespace mapwright::navcore
