// Fewer beams of a recorded scan, and where they look.
#pragma once

#include <cstddef>
#include <vector>

#include "navcore/localization/scan_weigher.hpp"
#include "navcore/logs/recorded_log.hpp"

namespace mapwright::navcore {

/// Some of a scan's beams as a laser of this project sees them: a fan that is symmetric about the
/// direction `heading` relative to the robot's.
struct SampledScan {
  LaserModel laser;
  Angle heading;
  std::vector<double> ranges;  ///< metres; laser.max_range_m where nothing came back from within it
};

/// At most `beams` (>= 2) of the scan's beams, equally spaced, as wide apart as they can be.
SampledScan sample_beams(const RecordedScan& scan, std::size_t beams, double max_range_m,
                         double height_m);

/// Weighs poses of a robot whose laser looks `heading` past the robot's own heading. Keeps a
/// reference to `weigher`.
class TurnedWeigher : public ScanWeigher {
 public:
  TurnedWeigher(const ScanWeigher& weigher, Angle heading)
      : weigher_(&weigher), heading_(heading) {}

  void weigh(std::span<const double> scan, const LaserModel& laser,
             const LikelihoodModel& likelihood, std::span<const Pose> poses,
             std::span<double> log_factors, unsigned threads) const override;

 private:
  const ScanWeigher* weigher_;
  Angle heading_;
};

}  // namespace mapwright::navcore
