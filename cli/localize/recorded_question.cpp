#include "cli/localize/recorded_question.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/log_files.hpp"
#include "cli/support/number_options.hpp"
#include "cli/support/number_table.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::uint64_t kMostParticles = 10'000'000;

bool given(const po::variables_map& values, const char* name) {
  return values.count(name) > 0 && !values[name].defaulted();
}

std::optional<std::size_t> optional_scan(const po::variables_map& values, const char* name) {
  if (!given(values, name)) return std::nullopt;
  return integer_option(values, name, 0, UINT32_MAX);
}

void refuse_simulation_options(const po::variables_map& values) {
  for (const char* name :
       {"pose", "trials", "iterations", "step", "robot-radius", "laser-noise", "occlusion", "fov",
        "compass-error", "no-compass", "temper", "known-start"}) {
    if (given(values, name)) {
      fail_usage(std::string("--") + name + " belongs to a simulated robot, not to --log");
    }
  }
}

// Those as sharp as the last: what a scan is weighed by in the end.
std::span<navcore::TrackingStage> last_stages(navcore::RecordedSettings& settings) {
  auto& stages = settings.tracker.stages;
  const auto blunt = std::find_if(stages.begin(), stages.end(), [&](const auto& stage) {
    return stage.sigma_m == stages.back().sigma_m;
  });
  return {blunt, stages.end()};
}

void read_filter(const po::variables_map& values, navcore::RecordedSettings& settings) {
  navcore::FilterSettings& filter = settings.filter;
  const auto number = [&](const char* name, double& target) {
    if (given(values, name)) target = number_option(values, name, 0.0);
  };
  const auto count = [&](const char* name, std::size_t& target) {
    if (given(values, name)) target = integer_option(values, name, 1, kMostParticles);
  };
  count("particles", filter.particles);
  count("first-particles", filter.first_particles);
  filter.first_particles = std::max(filter.first_particles, filter.particles);
  if (given(values, "alpha")) filter.likelihood.alpha = positive_option(values, "alpha");
  number("beta", filter.likelihood.beta);
  number("gamma", filter.likelihood.gamma);
  if (given(values, "sigma")) {
    settings.search.sigma_m = positive_option(values, "sigma");
    for (auto& stage : last_stages(settings)) stage.sigma_m = settings.search.sigma_m;
  }
}

navcore::RecordedSettings settings_for(const std::string& likelihood) {
  if (likelihood == "robust") return navcore::recorded_settings();
  if (likelihood == "report") return navcore::recorded_report_settings();
  fail_usage("--likelihood: '" + likelihood + "' is neither robust nor report");
}

void read_beams(const po::variables_map& values, navcore::RecordedSettings& settings) {
  if (given(values, "rays")) {
    settings.search.beams = integer_option(values, "rays", 2, 100'000);
    for (auto& stage : last_stages(settings)) stage.beams = settings.search.beams;
  }
  if (given(values, "max-range")) settings.max_range_m = positive_option(values, "max-range");
  settings.height_m = positive_option(values, "laser-height");
}

void read_start(const po::variables_map& values, RecordedQuestion& question) {
  auto& settings = question.settings;
  question.from_reference = values.count("from-reference") > 0;
  if (given(values, "initial-pose")) {
    if (question.from_reference)
      fail_usage("--initial-pose and --from-reference exclude each other");
    if (question.is_batch()) fail_usage("--initial-pose: --windows needs --from-reference instead");
    settings.initial_pose = parse_pose("initial-pose", values["initial-pose"].as<std::string>());
  }
  if (!given(values, "initial-error")) return;
  const auto error =
      parse_numbers("initial-error", values["initial-error"].as<std::string>(), 2, 2);
  if (error[0] < 0.0 || error[1] < 0.0) fail_usage("--initial-error: must not be negative");
  settings.initial_sigma_m = error[0];
  settings.initial_sigma_deg = error[1];
}

// Nothing but the times tells that a table of as many rows is of another log.
void warn_of_another_log(const RecordedQuestion& question,
                         const std::vector<navcore::RecordedScan>& scans,
                         const std::vector<OdometryRow>& rows, Console& console) {
  constexpr double kRounding_s = 0.1;
  double most_s = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    most_s = std::max(most_s, std::abs(rows[i].time_s - scans[i].time_s));
  }
  if (most_s <= kRounding_s) return;
  char text[64];
  std::snprintf(text, sizeof text, "%.1f", most_s);
  console.warning(std::string(display_path(question.odometry_path)) + ": its times are up to " +
                  text + " s off those of the log's scans; is it of another log?");
}

[[noreturn]] void fail_window(const std::string& path, std::size_t line, const std::string& what) {
  throw Error(ExitStatus::kInput, path + ":" + std::to_string(line) + ": " + what);
}

std::vector<ScanStretch> read_windows(const std::string& path, std::size_t scans) {
  const std::string name(display_path(path));
  const NumberTable table = read_number_table(path, {"first_scan", "last_scan"}, {});
  std::vector<ScanStretch> result;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double first = table.rows[i][0], last = table.rows[i][1];
    if (!(first >= 0.0 && first <= last && last < static_cast<double>(scans)) ||
        first != std::floor(first) || last != std::floor(last)) {
      fail_window(
          name, table.lines[i],
          "expected first_scan <= last_scan, whole numbers from 0 to " + std::to_string(scans - 1));
    }
    result.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(last)});
  }
  if (result.empty()) fail_window(name, 1, "holds no stretch");
  return result;
}

}  // namespace

void declare_recorded_options(po::options_description& options) {
  auto add = options.add_options();
  const auto text = [] { return po::value<std::string>(); };
  add("log", text(), "localize on a recorded log instead: a CARMEN log, plain or gzipped");
  add("odometry", text(),
      "with --log: CSV with columns scan,t,odom_x,odom_y,odom_theta and, to compare with, "
      "ref_x,ref_y,ref_theta (metres, radians). Without it the log's own odometry, which in "
      "'corrected' logs is no odometry any more");
  add("first-scan", text(), "with --log: first scan of the stretch to run over, from 0 [0]");
  add("last-scan", text(), "with --log: its last scan [the log's last]");
  add("windows", text(),
      "with --log: CSV with columns first_scan,last_scan; runs over each stretch in turn");
  add("from-reference",
      "with --log: track; believe to start at the reference's pose, off by --initial-error");
  add("kidnap",
      "with --windows: at its end the robot is carried off to the stretch half the table further "
      "on, which nobody tells the filter; how long until it is right again?");
}

bool asks_for_log(const po::variables_map& values) {
  if (values.count("log") > 0) return true;
  for (const char* name :
       {"odometry", "first-scan", "last-scan", "windows", "from-reference", "kidnap"}) {
    if (values.count(name) > 0) fail_usage(std::string("--") + name + " needs --log");
  }
  return false;
}

RecordedQuestion recorded_question(const po::variables_map& values) {
  refuse_simulation_options(values);
  RecordedQuestion question;
  const auto path = [&](const char* name) {
    return values.count(name) > 0 ? values[name].as<std::string>() : std::string();
  };
  question.log_path = path("log");
  question.odometry_path = path("odometry");
  question.windows_path = path("windows");
  question.likelihood = values["likelihood"].as<std::string>();
  question.settings = settings_for(question.likelihood);
  question.settings.keep_particles = values.count("with-particles") > 0;
  question.first_scan = optional_scan(values, "first-scan");
  question.last_scan = optional_scan(values, "last-scan");
  question.seed = seed_option(values);
  if (question.is_batch() && (question.first_scan || question.last_scan)) {
    fail_usage("--windows and --first-scan or --last-scan exclude each other");
  }
  question.kidnap = values.count("kidnap") > 0;
  if (question.kidnap && !question.is_batch()) fail_usage("--kidnap needs --windows");
  if (question.is_batch() && question.settings.keep_particles) {
    fail_usage("--with-particles: not with --windows");
  }
  if (question.likelihood == "report" && given(values, "gamma")) {
    fail_usage("--gamma belongs to --likelihood robust");
  }
  read_filter(values, question.settings);
  read_beams(values, question.settings);
  read_start(values, question);
  return question;
}

std::vector<navcore::RecordedStep> recorded_steps(const RecordedQuestion& question,
                                                  Console& console) {
  auto scans = read_log_file(question.log_path);
  std::vector<OdometryRow> rows;
  if (!question.odometry_path.empty()) {
    rows = read_odometry_file(question.odometry_path, scans.size());
    warn_of_another_log(question, scans, rows, console);
  }
  std::vector<navcore::RecordedStep> steps;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const OdometryRow row =
        rows.empty() ? OdometryRow{scans[i].time_s, scans[i].odometry, {}} : rows[i];
    steps.push_back({std::move(scans[i]), row.odometry, row.reference});
  }
  if (!steps.front().reference && (question.from_reference || question.is_batch())) {
    fail_usage("--from-reference and --windows need an --odometry file with a reference");
  }
  return steps;
}

std::vector<ScanStretch> stretches(const RecordedQuestion& question, std::size_t scans) {
  if (question.is_batch()) return read_windows(question.windows_path, scans);
  const std::size_t first = question.first_scan.value_or(0);
  const std::size_t last = question.last_scan.value_or(scans - 1);
  if (first > last || last >= scans) {
    fail_usage("--first-scan and --last-scan: the log has scans 0 to " + std::to_string(scans - 1));
  }
  return {{first, last}};
}

}  // namespace mapwright::cli
