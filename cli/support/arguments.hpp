// Reading option values: numbers, points, poses, boxes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mapcore/angle.hpp"

namespace mapwright::cli {

/// A finite number. Throws Error (kUsage) that names the option.
double parse_number(const std::string& option, const std::string& text);

/// A whole number from `least` to `most`. Throws Error (kUsage) that names the option: unlike
/// Boost.Program_options, which reads -1 as the greatest of all.
std::uint64_t parse_integer(const std::string& option, const std::string& text,
                            std::uint64_t least = 0, std::uint64_t most = UINT64_MAX);

/// "1,2,3": between `least` and `most` finite numbers.
std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t least, std::size_t most);

/// "x,y" in metres.
Point parse_point(const std::string& option, const std::string& text);

/// "x,y,deg": metres, degrees counter-clockwise from +x.
Pose parse_pose(const std::string& option, const std::string& text);

/// Joins "--name" "-20" to "--name=-20", since Boost.Program_options takes a value that begins with
/// '-' for another option.
std::vector<std::string> with_negative_values_joined(std::vector<std::string> arguments);

}  // namespace mapwright::cli
