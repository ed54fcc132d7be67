// Logs in the format of CARMEN, the Carnegie Mellon robot navigation toolkit.
#pragma once

#include <string_view>
#include <vector>

#include "mapcore/result.hpp"
#include "navcore/logs/recorded_log.hpp"

namespace mapwright::navcore {

/// Reads the front laser's scans, in order:
///
///     FLASER n r1 … rn x y theta odom_x odom_y odom_theta time host logger_time
///     ROBOTLASER1 type start fov step max_range accuracy remissions n r1 … rn m s1 … sm
///         laser_x laser_y laser_theta x y theta tv rv forward side axis time host logger_time
///
/// Metres, radians, seconds. FLASER does not say where its beams point: n of 180 or 360 mean steps
/// of 180°/n from −90°, an odd n steps of 180°/(n − 1) from −90° to 90°. Messages of other kinds
/// (ODOM, PARAM, …) and lines that begin with '#' are passed over.
///
/// Fails (kInput) with `name:line:` and what is wrong there: a line that begins with no CARMEN
/// message, a scan cut short, a field that is no number; or where there is no scan at all.
Result<std::vector<RecordedScan>> read_carmen_log(std::string_view text, std::string_view name);

}  // namespace mapwright::navcore
