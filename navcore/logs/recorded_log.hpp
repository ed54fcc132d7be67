// What a robot recorded: scans and odometry.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/angle.hpp"

namespace mapwright::navcore {

/// The beams of a recorded scan: equally spaced, counter-clockwise, seen from the robot's heading.
struct RecordedFan {
  std::size_t beams = 0;
  Angle first;  ///< direction of beam 0 relative to the heading
  Angle step;   ///< from one beam to the next, > 0

  friend bool operator==(const RecordedFan&, const RecordedFan&) = default;
};

/// One laser scan. Ranges are metres; infinity stands for a beam without echo.
struct RecordedScan {
  std::size_t line = 0;  ///< of the log, 1-based
  double time_s = 0.0;
  RecordedFan fan;
  std::vector<double> ranges;
  Pose odometry;  ///< of the robot, as the log has it: any frame, drifts
};

/// A laser reports a beam without echo as a number: SICK scanners as 81.83 to 81.91 m (error codes
/// 8183 to 8191 in centimetres) or 32.76 m (32767 in millimetres, cut), others as 50 or 80 m. True
/// where `range_m` is such a code to half a millimetre, or 0, negative or no number. Where the log
/// says how far the laser sees, that decides instead of the codes: that far or beyond is no echo.
bool is_no_return(double range_m, std::optional<double> laser_range_m = std::nullopt);

/// Direction of beam i relative to the heading.
constexpr Angle beam_direction(const RecordedFan& fan, std::size_t i) {
  return fan.first + static_cast<double>(i) * fan.step;
}

}  // namespace mapwright::navcore
