#include <algorithm>

#include "cli/localize/answer_writers.hpp"
#include "cli/localize/recorded_localization.hpp"
#include "cli/plan/places.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/blind_laser.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/laser_options.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/number_options.hpp"
#include "cli/support/ray_engine.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Lets a simulated robot find its place on a map with laser, compass and odometry: the experiment
of the report's section 4.1. The robot stands at --pose (which the filter is not told), scans, drives
about a metre, scans again, and so on; particles spread over all free space gather where the scans
agree with the map. With --initial-pose the filter starts there instead: position tracking.

--trials N runs N experiments from random places with room to drive and answers with shares and
errors after 1, 2, 4, ... iterations, with how far the filter was right when it said so, and which
runs were wrong: the true place lost, or places alike. With --known-start they track; position errors are
set against the sequential Fisher bound, which no filter beats (docs/localization.md).

--likelihood report is the report's filter to the letter; the default, robust, is explained in
docs/localization.md and finds its place far more often.

Examples:
  mapwright localize campus.txt --pose 40,30,90
  mapwright localize campus.txt --pose 40,30,90 --format json --with-particles > loc.json
  mapwright render campus.txt -o loc.png --overlay loc.json --iteration 1
  mapwright localize campus.txt --pose 40,30,90 --initial-pose 40.5,29.5,85 --particles 1000
  mapwright localize campus.txt --trials 100 --seed 1
  mapwright localize campus.txt --trials 100 --likelihood report
  mapwright localize campus.txt --trials 100 --known-start --particles 2000

With --log the robot is a recorded one: scans of a CARMEN log, odometry of a table. Where the table has
a reference, the error of each scan is told; --windows runs over many stretches.

  mapwright localize map.txt --log run.log.gz --odometry run.csv --first-scan 100 --last-scan 180
  mapwright localize map.txt --log run.log.gz --odometry run.csv --windows w.csv --from-reference

A simulated run has converged when at the end one place holds 95 % of the weight, within 0.5 m, and it is the
true one, to 0.5 m and 5 degrees. Sure of a wrong place is "mistaken".

Exit status 1 if the run did not converge, or fewer trials than --require asks for; 2 if --pose is no
place for a robot.
)";

constexpr std::uint64_t kMostParticles = 10'000'000;

class Localize : public Verb {
 public:
  std::string_view synopsis() const override {
    return "MAP (--pose X,Y,DEG | --trials N | --log FILE) [OPTIONS]";
  }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void declare_filter_options(po::options_description& options);
  void configure_start(const po::variables_map& values);
  void configure_filter(const po::variables_map& values);
  ExitStatus run_once(const Map& map, const navcore::FreeSpace& space, const RayEngine& engine,
                      Console& console) const;
  ExitStatus run_often(const Map& map, const navcore::FreeSpace& space, const RayEngine& engine,
                       Console& console) const;
  std::optional<navcore::BoundSummary> tracking(
      const Map& map, const std::vector<navcore::ExperimentRun>& runs) const;

  std::string map_path_;
  std::optional<RecordedQuestion> recorded_;  ///< with --log
  std::optional<Pose> pose_;
  std::size_t trials_ = 0;
  double required_percent_ = 50.0;
  LocalizeQuestion question_;
  unsigned threads_ = 0;
  RayEngineKind engine_ = RayEngineKind::kFast;
  bool json_ = false;
};

void Localize::declare(po::options_description& options,
                       po::positional_options_description& positionals) {
  declare_map_argument(options, positionals, map_path_);
  auto add = options.add_options();
  add("pose", po::value<std::string>(),
      "true pose of the robot at the first scan: x,y in metres, heading in degrees");
  add("trials", po::value<std::string>(), "run so many experiments from random places");
  add("require", text_value("50"),
      "with --trials: percentage of runs that must converge for exit status 0");
  add("iterations", text_value("32"), "scans of a run; before each but the first the robot drives");
  add("step", text_value("1"), "metres the robot drives between scans");
  add("robot-radius", text_value("0.4"), "of the driving robot, in metres");
  add("initial-pose", po::value<std::string>(),
      "track: where the filter believes to start, x,y in metres, heading in degrees");
  add("known-start", "with --trials: track; the filter believes to start near the truth");
  add("initial-error", text_value("0.5,5"),
      "with --initial-pose or --known-start: standard deviations of that belief, metres and "
      "degrees");
  declare_laser_options(options);
  declare_noise_options(options, "laser-noise", "0.05");
  declare_filter_options(options);
  declare_recorded_options(options);
  declare_engine_option(options, "fast");
  declare_seed(options, "of the random numbers, a whole number; trial i has seed + i");
  declare_threads(options);
  add("with-particles", "put particles and scans into the JSON answer");
  declare_answer_format(options);
}

void Localize::declare_filter_options(po::options_description& options) {
  auto add = options.add_options();
  add("likelihood", text_value("robust"), "robust, or report: Eq. (4)-(6) to the letter");
  add("particles", text_value("6000"),
      "number of particles, about; with robust each place has some");
  add("first-particles", po::value<std::string>(),
      "scored against the first scan only [robust: 50000, report: as --particles]");
  add("alpha", text_value("1"), "weight of the normal part of Eq. (5)");
  add("beta", po::value<std::string>(),
      "weight of its uniform part, for beams shorter than the map says [robust: 1, report: 0.1]");
  add("gamma", po::value<std::string>(),
      "the same for longer beams; robust only, the report has none [0.5]");
  add("sigma", po::value<std::string>(),
      "standard deviation of the normal part, in metres [robust: 0.15, report: 0.5]");
  add("temper", po::value<std::string>(),
      "exponent of a scan's likelihood, above 0 and up to 1; robust only [0.3]");
  add("compass-error", text_value("3"), "standard deviation of the compass, degrees; read once");
  add("no-compass", "the heading is not known at the start");
}

void Localize::configure(const po::variables_map& values) {
  threads_ = threads_option(values);
  required_percent_ = number_option(values, "require", 0.0, 100.0);
  engine_ = ray_engine_kind(values);
  json_ = json_wanted(values);
  if (values.count("with-particles") > 0 && !json_) {
    fail_usage("--with-particles: needs --format json");
  }
  if (asks_for_log(values)) {
    recorded_ = recorded_question(values);
    return;
  }
  auto& settings = question_.settings;
  configure_filter(values);
  settings.laser = laser_model(values);
  settings.laser_noise = laser_noise(values, "laser-noise");
  settings.iterations = integer_option(values, "iterations", 1, 1'000'000);
  settings.step_m = number_option(values, "step", 0.0);
  settings.robot_radius_m = number_option(values, "robot-radius", 0.0);
  settings.compass_error_deg = number_option(values, "compass-error", 0.0);
  settings.heading_known = values.count("no-compass") == 0;
  settings.keep_particles = values.count("with-particles") > 0;
  question_.seed = seed_option(values);
  configure_start(values);
}

void Localize::configure_start(const po::variables_map& values) {
  auto& settings = question_.settings;
  if ((values.count("pose") > 0) == (values.count("trials") > 0)) {
    fail_usage("needs one of --pose X,Y,DEG, --trials N and --log FILE");
  }
  settings.start_known = values.count("known-start") > 0;
  if (settings.start_known && values.count("trials") == 0) {
    fail_usage("--known-start needs --trials; with --pose give --initial-pose");
  }
  const auto error =
      parse_numbers("initial-error", values["initial-error"].as<std::string>(), 2, 2);
  if (error[0] < 0.0 || error[1] < 0.0) fail_usage("--initial-error: must not be negative");
  settings.initial_sigma_m = error[0];
  settings.initial_sigma_deg = error[1];
  if (values.count("trials") > 0) {
    if (values.count("initial-pose") > 0) fail_usage("--initial-pose needs --pose, not --trials");
    if (settings.keep_particles) fail_usage("--with-particles needs --pose, not --trials");
    trials_ = integer_option(values, "trials", 1, 1'000'000);
    return;
  }
  pose_ = parse_pose("pose", values["pose"].as<std::string>());
  if (values.count("initial-pose") == 0) return;
  settings.initial_pose = parse_pose("initial-pose", values["initial-pose"].as<std::string>());
}

void Localize::configure_filter(const po::variables_map& values) {
  const auto& word = values["likelihood"].as<std::string>();
  if (word != "robust" && word != "report") {
    fail_usage("--likelihood: '" + word + "' is neither robust nor report");
  }
  const bool robust = word == "robust";
  question_.likelihood = word;
  auto& filter = question_.settings.filter;
  filter = robust ? navcore::robust_settings() : navcore::report_settings();
  const auto given = [&](const char* name) { return values.count(name) > 0; };
  if (!robust && (given("gamma") || given("temper"))) {
    fail_usage("--gamma and --temper belong to --likelihood robust");
  }
  filter.particles = integer_option(values, "particles", 1, kMostParticles);
  if (!robust) filter.first_particles = filter.particles;
  if (given("first-particles")) {
    filter.first_particles = integer_option(values, "first-particles", 1, kMostParticles);
  }
  filter.first_particles = std::max(filter.first_particles, filter.particles);
  filter.likelihood.alpha = positive_option(values, "alpha");
  if (given("beta")) filter.likelihood.beta = number_option(values, "beta", 0.0);
  if (given("gamma")) filter.likelihood.gamma = number_option(values, "gamma", 0.0);
  if (given("sigma")) filter.likelihood.sigma_m = positive_option(values, "sigma");
  if (given("temper")) filter.temper = positive_option(values, "temper", 1.0);
}

// A belief may be wrong, but not off the map: nothing there could correct it.
void require_within(const Border& border, const std::optional<Pose>& initial_pose) {
  if (initial_pose && !border.contains(initial_pose->position())) {
    fail_usage("--initial-pose " + place_text(initial_pose->position()) +
               " lies outside of the map's border");
  }
}

ExitStatus Localize::run(Console& console) {
  const MapDocument document = read_sound_map_file(map_path_);
  const auto& start =
      recorded_ ? recorded_->settings.initial_pose : question_.settings.initial_pose;
  require_within(document.map.border, start);
  warn_of_blind_laser(document.map,
                      recorded_ ? recorded_->settings.height_m : question_.settings.laser.height_m,
                      console);
  if (recorded_) {
    return localize_recorded(document.map, engine_, *recorded_,
                             {json_, threads_, required_percent_}, console);
  }
  const navcore::FreeSpace space(document.map);
  const RayEngine engine(document.map, engine_);
  if (!pose_) return run_often(document.map, space, engine, console);
  const auto reason = why_not_standing(document.map, space, pose_->position(), 0.0, "--pose");
  if (reason) fail_usage(*reason);
  return run_once(document.map, space, engine, console);
}

ExitStatus Localize::run_once(const Map& map, const navcore::FreeSpace& space,
                              const RayEngine& engine, Console& console) const {
  navcore::ExperimentSettings settings = question_.settings;
  settings.filter.threads = threads_;
  const auto run = value_or_throw(navcore::run_experiment(space, engine.caster(), engine.weigher(),
                                                          settings, *pose_, question_.seed));
  const auto bounds = navcore::sequential_bounds(navcore::GradientCaster(map), settings, run);
  if (json_) {
    write_run_json(console.out(), question_, run, bounds);
  } else {
    write_run_text(console.out(), run, bounds);
  }
  return run.converged() ? ExitStatus::kSuccess : ExitStatus::kNegative;
}

std::optional<navcore::BoundSummary> Localize::tracking(
    const Map& map, const std::vector<navcore::ExperimentRun>& runs) const {
  if (!question_.settings.tracks()) return std::nullopt;
  const navcore::GradientCaster caster(map);
  std::vector<std::vector<navcore::AccuracyBound>> bounds;
  for (const auto& run : runs) {
    bounds.push_back(navcore::sequential_bounds(caster, question_.settings, run));
  }
  return navcore::summarize_bounds(runs, bounds);
}

ExitStatus Localize::run_often(const Map& map, const navcore::FreeSpace& space,
                               const RayEngine& engine, Console& console) const {
  const auto runs = value_or_throw(navcore::run_trials(space, engine.caster(), engine.weigher(),
                                                       question_.settings, trials_, question_.seed,
                                                       threads_, console.progress("localizing")));
  const TrialsAnswer answer{navcore::summarize(runs), tracking(map, runs)};
  const navcore::TrialSummary& summary = answer.summary;
  if (json_) {
    write_trials_json(console.out(), question_, runs, answer);
  } else {
    write_trials_text(console.out(), runs, answer);
  }
  const double required = required_percent_ * static_cast<double>(summary.trials);
  return 100.0 * static_cast<double>(summary.converged) >= required ? ExitStatus::kSuccess
                                                                    : ExitStatus::kNegative;
}

}  // namespace

std::unique_ptr<Verb> make_localize() {
  return std::make_unique<Localize>();
}

}  // namespace mapwright::cli
