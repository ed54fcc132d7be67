// The report's localization experiment, simulated (section 4.1, figures 4 and 5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mapcore/progress.hpp"
#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localization/particle_filter.hpp"
#include "navcore/sensors/compass.hpp"
#include "navcore/sensors/laser_noise.hpp"

namespace mapwright::navcore {

/// What happens in one experiment. The defaults are the report's where it prints them.
struct ExperimentSettings {
  LaserModel laser;
  LaserNoise laser_noise;
  FilterSettings filter = robust_settings();
  std::size_t iterations = 32;
  double compass_error_deg = kCompassError_deg;  ///< read once, at the start
  bool heading_known = true;                     ///< false: no compass at all
  double step_m = 1.0;                           ///< driven before each iteration but the first
  double robot_radius_m = 0.4;
  std::optional<Pose> initial_pose;  ///< tracking: where the filter believes to start
  bool start_known = false;          ///< tracking: it believes so near the truth as the next say
  double initial_sigma_m = 0.5;      ///< standard deviations of that belief
  double initial_sigma_deg = 5.0;
  bool keep_particles = false;  ///< in the records, with the scans

  bool tracks() const { return start_known || initial_pose; }
};

/// The estimate is right when it is this near to the truth.
inline constexpr double kRight_m = 0.5;
inline constexpr double kRight_deg = 5.0;

/// A wrong place was not worth believing where the scans give the truth this probability.
inline constexpr double kDecided = 0.95;

/// The filter takes itself for converged when one mode holds this share of the weight, and its
/// particles spread no further than kRight_m.
inline constexpr double kConvergedShare = 0.95;

bool believes_converged(const PoseEstimate& estimate);

/// The state after one iteration.
struct IterationRecord {
  std::size_t n = 0;  ///< 1-based
  UpdateReport update;
  PoseEstimate estimate;
  Pose true_pose;
  OdometryStep step;  ///< the true one that led here from the last iteration's pose
  double position_error_m = 0.0;
  Angle heading_error;    ///< >= 0
  bool believes = false;  ///< the filter takes itself for converged
  /// How much better the true pose explains the scan than the estimate does: difference of the
  /// logarithms of the scan's factor (likelihood.hpp), untempered.
  double truth_advantage = 0.0;
  double claim = 0.0;        ///< weight within kRight_m and kRight_deg of the estimate
  double truth_share = 0.0;  ///< weight of the particles within a mode's reach of the truth
  std::vector<double> scan;  ///< with keep_particles: as perceived
  ParticleSet particles;     ///< with keep_particles

  /// Within kRight_m and kRight_deg of the truth.
  bool is_right() const;
};

/// One run.
struct ExperimentRun {
  std::uint64_t seed = 0;
  Pose start;  ///< true pose at the first iteration
  std::vector<IterationRecord> iterations;

  /// Of a run that is wrong at its end: the probability of the truth if only that and the place
  /// taken for it are possible (evidence_for_truth).
  std::optional<double> truth_evidence;

  /// The filter believes to be converged at the end, and is right.
  bool converged() const;
  /// The filter believes to be converged at the end, and is wrong.
  bool mistaken() const;
  /// Wrong at the end, although the scans decide for the truth: the true place was lost. Where they
  /// do not, the places look alike.
  bool lost() const { return truth_evidence.value_or(0.0) >= kDecided; }
  /// The sum over all iterations.
  double truth_advantage() const;
  /// First iteration (1-based) from which on the estimate stays right; nothing if it is wrong at
  /// the end.
  std::optional<std::size_t> right_from() const;
};

/// Runs from the true pose `start`. Fails (kUsage) if the robot does not stand in free space there,
/// or if the map has no free space to search.
Result<ExperimentRun> run_experiment(const FreeSpace& space, const RayCaster& caster,
                                     const ScanWeigher& weigher, const ExperimentSettings& settings,
                                     const Pose& start, std::uint64_t seed);

/// Runs `trials` times from random true poses where a robot has room to drive; trial i has the seed
/// `seed` + i. Trials are spread over `threads` threads. Fails like `run_experiment`.
Result<std::vector<ExperimentRun>> run_trials(const FreeSpace& space, const RayCaster& caster,
                                              const ScanWeigher& weigher,
                                              const ExperimentSettings& settings,
                                              std::size_t trials, std::uint64_t seed,
                                              unsigned threads, const Progress& progress = {});

}  // namespace mapwright::navcore
