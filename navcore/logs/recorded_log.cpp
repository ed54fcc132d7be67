#include "navcore/logs/recorded_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapwright::navcore {
namespace {

constexpr double kCodeTolerance_m = 5e-4;

// SICK's codes run from 8183 (nothing within range) to 8191 (no valid measurement).
constexpr double kFirstSickCode = 8183.0;
constexpr double kLastSickCode = 8191.0;
constexpr std::array kOtherCodes_m{32.76, 32.767, 50.0, 80.0};

bool is_sick_code(double range, double unit_m) {
  const double code = range / unit_m;
  const double whole = std::round(code);
  return whole >= kFirstSickCode && whole <= kLastSickCode &&
         std::abs(code - whole) * unit_m <= kCodeTolerance_m;
}

}  // namespace

bool is_no_return(double range_m, std::optional<double> laser_range_m) {
  if (!(range_m > 0.0) || !std::isfinite(range_m)) return true;
  if (laser_range_m) return range_m >= *laser_range_m - kCodeTolerance_m;
  if (is_sick_code(range_m, 0.01)) return true;
  return std::any_of(kOtherCodes_m.begin(), kOtherCodes_m.end(),
                     [&](double code_m) { return std::abs(range_m - code_m) <= kCodeTolerance_m; });
}

}  // namespace mapwright::navcore
