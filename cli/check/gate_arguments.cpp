#include "cli/check/gate_arguments.hpp"

#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/laser_options.hpp"
#include "cli/support/number_options.hpp"

namespace mapwright::cli {

namespace po = boost::program_options;

void declare_gate_options(po::options_description& options) {
  auto add = options.add_options();
  add("robot-radius", text_value("0.3"), "of the robot, a disc, in metres");
  add("ramps", text_value("free"),
      "free: driven across like open ground; avoid: their footprints block");
  add("plans", text_value("20"),
      "paths to plan between random places of the largest area; 0: none");
  add("trials", text_value("10"), "localization runs from random places; 0: none");
  add("min-converged", text_value("0.8"),
      "share of the localization runs, from 0 to 1, that must find their place (else N104)");
  add("localizability", text_value("1000"),
      "places, spread over the map, at which to look what a scan can tell (N107, N108); 0: none");
  add("min-unreachable", text_value("1"),
      "smallest area, in m², that N102 reports as out of reach");
  declare_laser_options(options);
  declare_seed(options, "of the random numbers, a whole number");
}

validators::GateOptions gate_options(const po::variables_map& values) {
  const auto text = [&](const char* name) { return values[name].as<std::string>(); };
  validators::GateOptions options;
  auto& robot = options.deployment;
  robot.robot_radius_m = number_option(values, "robot-radius", 0.0);
  options.min_unreachable_m2 = number_option(values, "min-unreachable", 0.0);
  options.min_converged = number_option(values, "min-converged", 0.0, 1.0);
  robot.plans = integer_option(values, "plans", 0, 1'000'000);
  robot.localization_trials = integer_option(values, "trials", 0, 1'000'000);
  robot.localizability_places = integer_option(values, "localizability", 0, 1'000'000);
  robot.localization.laser = laser_model(values);
  robot.seed = seed_option(values);
  if (text("ramps") != "free" && text("ramps") != "avoid") {
    fail_usage("--ramps: '" + text("ramps") + "' is neither free nor avoid");
  }
  if (text("ramps") == "avoid") robot.ramps = navcore::RampPolicy::kAvoid;
  return options;
}

std::set<std::string> given_options(const po::variables_map& values) {
  std::set<std::string> given;
  for (const auto& [name, value] : values) {
    if (!value.defaulted()) given.insert(name);
  }
  return given;
}

validators::GateOptions with_profile(validators::GateOptions options, validators::Profile profile,
                                     const std::set<std::string>& given) {
  if (given.count("robot-radius") > 0) profile.robot_radius_m.reset();
  if (given.count("laser-height") > 0) profile.laser_height_m.reset();
  if (given.count("max-range") > 0) profile.max_range_m.reset();
  if (given.count("min-unreachable") > 0) profile.min_unreachable_m2.reset();
  if (given.count("min-converged") > 0) profile.min_converged.reset();
  apply_profile(profile, options);
  return options;
}

}  // namespace mapwright::cli
