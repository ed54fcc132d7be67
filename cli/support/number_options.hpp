// Option values that are numbers within limits.
#pragma once

#include <boost/program_options.hpp>
#include <cmath>
#include <string>

namespace mapwright::cli {

/// The number of option `name`, which is text with a default. Throws Error (kUsage) that names the
/// option if it is no finite number in [least, most].
double number_option(const boost::program_options::variables_map& values, const std::string& name,
                     double least = -HUGE_VAL, double most = HUGE_VAL);

/// The same for numbers that must be greater than 0.
double positive_option(const boost::program_options::variables_map& values, const std::string& name,
                       double most = HUGE_VAL);

/// True if option "format" says json, false if text. Throws Error (kUsage) for anything else.
bool json_wanted(const boost::program_options::variables_map& values);

}  // namespace mapwright::cli
