// What `mapwright localize --log` is asked: options, and the log they name.
#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/support/console.hpp"
#include "navcore/localization/recorded_run.hpp"

namespace mapwright::cli {

struct ScanStretch {
  std::size_t first = 0, last = 0;
};

/// The options of localize that belong to --log, and what the others mean there.
struct RecordedQuestion {
  std::string log_path, odometry_path, windows_path;
  std::optional<std::size_t> first_scan, last_scan;
  std::string likelihood;  ///< "robust" or "report"
  navcore::RecordedSettings settings;
  bool from_reference = false;  ///< tracking: starts near the reference's pose
  bool kidnap = false;          ///< after each stretch the robot is carried off to another
  std::uint64_t seed = 1;

  bool is_batch() const { return !windows_path.empty(); }
};

void declare_recorded_options(boost::program_options::options_description& options);

/// True if --log is given.
bool asks_for_log(const boost::program_options::variables_map& values);

/// Throws Error (kUsage) for what makes no sense, also for options that only a simulated robot has.
RecordedQuestion recorded_question(const boost::program_options::variables_map& values);

/// Log and odometry together; without an odometry file the log's own. Warns of one whose times are
/// not the log's. Throws Error (kInput).
std::vector<navcore::RecordedStep> recorded_steps(const RecordedQuestion& question,
                                                  Console& console);

/// The stretches to run over, all within the log. Throws Error.
std::vector<ScanStretch> stretches(const RecordedQuestion& question, std::size_t scans);

}  // namespace mapwright::cli
