// How well any filter can know the robot's pose along a way.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "navcore/localizability/scan_information.hpp"
#include "navcore/localization/experiment.hpp"
#include "navcore/localization/trial_summary.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// The posterior Cramér-Rao bound along a driven way (Tichavský, Muravchik, Nehorai, Posterior
/// Cramér-Rao bounds for discrete-time nonlinear filtering, 1998), with the model linearised at the
/// true poses: what start, odometry and scans tell together. Informations are kept, not
/// covariances, so that a start that tells nothing is as good as any other.
class SequentialBound {
 public:
  explicit SequentialBound(const PoseInformation& start) : information_(start) {}

  /// The robot drives `step` from the true pose `from`. What was known moves along,
  /// (F J⁻¹ Fᵀ + Q)⁻¹ in the form (1 + J′Q)⁻¹ J′, J′ = F⁻ᵀ J F⁻¹, which needs no inverse of J or Q.
  void move(const Pose& from, const OdometryStep& step, const OdometryNoise& noise);

  /// It takes a scan of that information.
  void look(const PoseInformation& scan) { information_ += scan; }

  const PoseInformation& information() const { return information_; }

 private:
  PoseInformation information_;
};

/// Standard deviation of the position, any direction: root of the sum of both squares.
double position_bound_m(const AccuracyBound& bound);

/// What the filter of an experiment knows before its first scan: its belief in the initial pose, or
/// what the compass says, or nothing.
PoseInformation start_information(const ExperimentSettings& settings);

/// The bound after each iteration of a run. A beam that may be occluded counts by the probability
/// that it is not, which is more than it tells: the bound stays one.
std::vector<AccuracyBound> sequential_bounds(const GradientCaster& caster,
                                             const ExperimentSettings& settings,
                                             const ExperimentRun& run);

/// Errors and bounds of the position over all iterations of some runs, in metres. An iteration
/// whose bound is infinite counts in neither.
struct BoundSummary {
  MedianAndP95 error_m;
  double rms_error_m = 0.0;
  double rms_bound_m = 0.0;
};

/// bounds[i] are those of runs[i]. Nothing where no bound is finite.
std::optional<BoundSummary> summarize_bounds(std::span<const ExperimentRun> runs,
                                             std::span<const std::vector<AccuracyBound>> bounds);

}  // namespace mapwright::navcore
