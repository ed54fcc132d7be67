// Filters that find a robot's pose, scan by scan.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "navcore/free_space.hpp"
#include "navcore/localization/heading_prior.hpp"
#include "navcore/localization/particles.hpp"
#include "navcore/localization/pose_estimate.hpp"

namespace mapwright::navcore {

/// What an update did.
struct UpdateReport {
  std::size_t particles = 0;         ///< that were scored
  double effective_particles = 0.0;  ///< the whole scan's weights leave, unresampled
  bool contradicted = false;         ///< the scan was impossible at each particle; weights kept
  bool resampled = false;
};

/// A filter whose belief is a set of particles. The same settings, seed and inputs give the same
/// particles for any number of threads.
class PoseFilter {
 public:
  virtual ~PoseFilter() = default;

  /// Anywhere in free space, heading uniform or near the compass reading. False if there is no free
  /// space. The filter keeps a reference to `space`.
  virtual bool start_anywhere(const FreeSpace& space,
                              const std::optional<HeadingPrior>& heading) = 0;

  /// Near a pose: position tracking. Gaussian with these standard deviations. With `space` (kept,
  /// as above) the robot may turn out to be elsewhere.
  virtual void start_at(const Pose& pose, double sigma_m, double sigma_deg,
                        const FreeSpace* space = nullptr) = 0;

  /// The robot moved; encoders say how.
  virtual void move(const OdometryStep& step) = 0;

  /// The robot took a scan: as many ranges as the laser model has rays.
  virtual UpdateReport update(std::span<const double> scan) = 0;

  virtual const ParticleSet& particles() const = 0;
  PoseEstimate estimate() const { return estimate_pose(particles()); }
};

}  // namespace mapwright::navcore
