#include "cli/support/laser_options.hpp"

#include <string>

#include "cli/support/common_options.hpp"
#include "cli/support/number_options.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::uint64_t kMostRays = 1'000'000;

}  // namespace

void declare_laser_options(po::options_description& options) {
  auto add = options.add_options();
  add("rays", text_value("131"), "number of rays of a scan");
  add("fov", text_value("180"), "field of view in degrees, above 0 and up to 360");
  add("max-range", text_value("15"),
      "of the laser, in metres: what a ray reads that meets nothing");
  add("laser-height", text_value("0.5"),
      "of the laser above the ground, in metres: what is not higher is not seen");
}

navcore::LaserModel laser_model(const po::variables_map& values) {
  navcore::LaserModel laser;
  laser.rays = integer_option(values, "rays", 1, kMostRays);
  laser.fov_deg = positive_option(values, "fov", 360.0);
  laser.max_range_m = positive_option(values, "max-range");
  laser.height_m = positive_option(values, "laser-height");
  return laser;
}

void declare_noise_options(po::options_description& options, const char* noise_name,
                           const char* default_noise_m) {
  auto add = options.add_options();
  add(noise_name, text_value(default_noise_m), "standard deviation of a range, in metres");
  add("occlusion", text_value("0"),
      "share of the beams, from 0 to 1, that people and cars stop somewhere on their way");
}

navcore::LaserNoise laser_noise(const po::variables_map& values, const char* noise_name) {
  return {number_option(values, noise_name, 0.0), number_option(values, "occlusion", 0.0, 1.0)};
}

}  // namespace mapwright::cli
