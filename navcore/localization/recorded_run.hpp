// Localization on what a robot recorded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localization/beam_sampling.hpp"
#include "navcore/localization/particle_filter.hpp"
#include "navcore/localization/scan_quality.hpp"

namespace mapwright::navcore {

/// A robot's way: one entry a scan.
struct RecordedStep {
  RecordedScan scan;
  Pose odometry;                  ///< dead reckoning: any frame, drifts
  std::optional<Pose> reference;  ///< map frame, where known
};

/// How the filter looks at a scan.
struct LookSettings {
  std::size_t beams = 61;  ///< NL
  double sigma_m = 0.15;   ///< σm
  double evidence = 12.0;  ///< neighbouring beams err together: a scan counts as so many
                           ///< independent beams, whatever NL (τ = this / NL)
  std::size_t least_particles = 100;
  double elsewhere = 0.0;  ///< as in FilterSettings
  std::size_t elsewhere_particles = 0;
};

struct RecordedSettings {
  FilterSettings filter;
  double max_range_m = 25.0;    ///< longer readings say no more than that
  double height_m = 0.5;        ///< of the laser
  bool keep_particles = false;  ///< in the iterations, with what was seen

  /// A filter searches until it has been converged for a while: many particles, blunt, and the
  /// robot may be anywhere. Then it tracks: few particles, sharp. Where scans no longer fit as they
  /// used to it recovers, more soberly than it searches; if that does not help it starts over.
  LookSettings search, track, recover;
  std::size_t confirmation = 5;  ///< converged for so many scans in a row
  double lost_share = 0.3;       ///< recovers where ScanQuality says more
  std::size_t patience = 10;     ///< starts over after so many such scans in a row
  QualityDecay quality;

  std::optional<Pose> initial_pose;  ///< tracking; else global localization, heading unknown
  double initial_sigma_m = 0.3;
  double initial_sigma_deg = 5.0;
};

/// Settings for recorded logs (docs/localization.md says where they come from).
RecordedSettings recorded_settings();

/// The report's filter to the letter, on all beams up to the report's 131.
RecordedSettings recorded_report_settings();

/// The state after one scan.
struct RecordedIteration {
  std::size_t scan = 0;  ///< its number in the log, from 0
  double time_s = 0.0;
  std::size_t beams = 0;
  UpdateReport update;
  PoseEstimate estimate;
  bool tracked = false;   ///< looked at sharply
  bool believes = false;  ///< the filter takes itself for converged
  std::optional<Pose> reference;
  double position_error_m = 0.0;  ///< with a reference
  Angle heading_error;            ///< >= 0, with a reference
  double processor_s = 0.0;       ///< of this thread; all that the scan took
  SampledScan seen;               ///< with keep_particles
  ParticleSet particles;          ///< with keep_particles

  bool is_right() const;  ///< within kRight_m and kRight_deg of the reference
};

struct RecordedRun {
  std::size_t first_scan = 0, last_scan = 0;
  std::vector<RecordedIteration> iterations;
};

/// Runs the filter over steps first … last (last < steps.size()). Fails (kUsage) if the map has no
/// free space to search.
Result<RecordedRun> run_recorded(const FreeSpace& space, const ScanWeigher& weigher,
                                 const RecordedSettings& settings,
                                 std::span<const RecordedStep> steps, std::size_t first,
                                 std::size_t last, std::uint64_t seed);

/// What a run with a reference came to.
struct RecordedVerdict {
  /// From some scan on at least 98 % of the scans are right, and so are all of the last tenth.
  bool strict = false;
  bool strict_from_start = false;         ///< the same from the first scan on: for tracking
  std::optional<std::size_t> right_from;  ///< position in `iterations` of that scan
  double way_m = 0.0;                     ///< driven up to it, by the reference
  std::optional<double> median_error_m, p95_error_m;  ///< from it on
};

/// Requires a reference in every iteration.
RecordedVerdict judge(const RecordedRun& run);

}  // namespace mapwright::navcore
