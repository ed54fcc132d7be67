#include "cli/support/number_options.hpp"

#include <cstdio>

#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

std::string short_text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

[[noreturn]] void fail_limits(const std::string& name, double value, const std::string& limits) {
  fail_usage("--" + name + ": must be " + limits + ", got " + short_text(value));
}

std::string limits_text(double least, double most) {
  if (most == HUGE_VAL) return "at least " + short_text(least);
  if (least == -HUGE_VAL) return "at most " + short_text(most);
  return "from " + short_text(least) + " to " + short_text(most);
}

}  // namespace

double number_option(const po::variables_map& values, const std::string& name, double least,
                     double most) {
  const double value = parse_number(name, values[name].as<std::string>());
  if (value < least || value > most) fail_limits(name, value, limits_text(least, most));
  return value;
}

double positive_option(const po::variables_map& values, const std::string& name, double most) {
  const double value = parse_number(name, values[name].as<std::string>());
  if (value <= 0.0) fail_limits(name, value, "greater than 0");
  if (value > most) fail_limits(name, value, limits_text(-HUGE_VAL, most));
  return value;
}

std::uint64_t integer_option(const po::variables_map& values, const std::string& name,
                             std::uint64_t least, std::uint64_t most) {
  return parse_integer(name, values[name].as<std::string>(), least, most);
}

}  // namespace mapwright::cli
