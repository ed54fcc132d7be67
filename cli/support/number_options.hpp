// Option values that are numbers within limits.
#pragma once

#include <boost/program_options.hpp>
#include <cmath>
#include <cstdint>
#include <string>

namespace mapwright::cli {

/// The number of option `name`, which is text with a default. Throws Error (kUsage) that names the
/// option if it is no finite number in [least, most].
double number_option(const boost::program_options::variables_map& values, const std::string& name,
                     double least = -HUGE_VAL, double most = HUGE_VAL);

/// The same for numbers that must be greater than 0.
double positive_option(const boost::program_options::variables_map& values, const std::string& name,
                       double most = HUGE_VAL);

/// The whole number of option `name`, which is text with a default, from `least` to `most`. Throws
/// Error (kUsage) that names the option.
std::uint64_t integer_option(const boost::program_options::variables_map& values,
                             const std::string& name, std::uint64_t least = 0,
                             std::uint64_t most = UINT64_MAX);

}  // namespace mapwright::cli
