// Localization on what a robot recorded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localization/localizer.hpp"

namespace mapwright::navcore {

/// A robot's way: one entry a scan.
struct RecordedStep {
  RecordedScan scan;
  Pose odometry;                  ///< dead reckoning: any frame, drifts
  std::optional<Pose> reference;  ///< map frame, where known
};

/// The state after one scan.
struct RecordedIteration : LocalizerLook {
  std::size_t scan = 0;  ///< its number in the log, from 0
  double time_s = 0.0;
  std::optional<Pose> reference;
  double position_error_m = 0.0;  ///< with a reference
  Angle heading_error;            ///< >= 0, with a reference
  double processor_s = 0.0;       ///< of this thread; all that the scan took

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
