// Recorded logs and odometry tables, read by the rules of docs/cli.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "navcore/logs/recorded_log.hpp"

namespace mapwright::cli {

/// The scans of a CARMEN log, plain or gzipped (told by its first bytes); "-" is standard input.
/// Throws Error (kInput) that names file and line.
std::vector<navcore::RecordedScan> read_log_file(const std::string& path);

/// A row of an odometry table.
struct OdometryRow {
  double time_s = 0.0;
  Pose odometry;                  ///< dead reckoning: any frame, drifts
  std::optional<Pose> reference;  ///< map frame, where the table has one
};

/// Reads a CSV file with columns scan,t,odom_x,odom_y,odom_theta and, for a reference,
/// ref_x,ref_y,ref_theta (metres, radians). Row i belongs to scan i of the log: `scan` must count
/// 0, 1, 2, … up to `scans` − 1. Throws Error (kInput).
std::vector<OdometryRow> read_odometry_file(const std::string& path, std::size_t scans);

}  // namespace mapwright::cli
