#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/diff/diff_answer.hpp"
#include "cli/diff/diff_wording.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/laser_options.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/map_reports.hpp"
#include "cli/support/number_options.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Tells what changed from one map to another: obstacles that were added, removed, moved (how far),
reshaped, or have other attributes, and the border. Obstacles are matched by shape, so that other
numbers or another order are no difference. Then what it means to a robot: which scans, routes and
reachable areas are not what they were (random places from --seed; see --no-navigation).

Examples:
  mapwright diff old.txt new.txt
  mapwright diff old.txt new.txt --format html -o diff.html
  mapwright diff old.txt new.txt --no-navigation --format json | jq .counts
  mapwright diff old.txt new.txt --picture diff.png --place 5,5 --place 80,60
  git config diff.mapwright.command 'mapwright diff --git'     (docs/diff.md)

Exit status 0 if nothing differs, 1 if something does; with --git always 0, as git asks for.
)";

// Where the map changed.
std::vector<Box> boxes_of(const DiffAnswer& answer) {
  std::vector<Box> boxes;
  for (const auto& change : answer.obstacles.changes) {
    if (!change.is_difference()) continue;
    Box box = extent(obstacle_of(answer, change));
    if (change.before && !box.is_empty()) {
      const Box old_box = extent(answer.before.obstacles[*change.before]);
      if (!old_box.is_empty()) {
        box.add({old_box.min_x, old_box.min_y});
        box.add({old_box.max_x, old_box.max_y});
      }
    }
    if (!box.is_empty()) boxes.push_back(box);
  }
  return boxes;
}

class Diff : public Verb {
 public:
  std::string_view synopsis() const override { return "OLD NEW [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }
  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void configure_paths();
  void configure_git_paths();
  void configure_navigation(const po::variables_map& values);
  Map read(const std::string& path, Console& console) const;
  void compare_navigation(DiffAnswer& answer) const;
  void write(std::ostream& out, const DiffAnswer& answer, bool colour) const;

  std::vector<std::string> arguments_;
  std::string old_path_, new_path_, old_name_, new_name_;
  std::string format_, output_, picture_;
  std::vector<std::string> places_;
  bool git_ = false, no_navigation_ = false, skip_broken_ = false;
  MapDiffOptions options_;
  navcore::NavigationDiffSettings navigation_;
};

void Diff::declare(po::options_description& options,
                   po::positional_options_description& positionals) {
  auto add = options.add_options();
  add("map", po::value(&arguments_)->required()->composing(),
      "the old map and the new one; - reads standard input");
  add("format", po::value(&format_)->default_value("text"), "of the answer: text, json or html");
  add("output,o", po::value(&output_)->default_value("-"),
      "where to write it; - is standard output");
  add("picture", po::value(&picture_),
      "also draw the new map with its changes: a file .svg, .png or .pdf");
  add("tolerance", text_value("0.0005"),
      "coordinates and heights that differ by no more, in metres, are the same");
  add("longest-move", text_value("10"),
      "an obstacle with another number that is farther off than this, in metres, is another one");
  add("no-navigation", po::bool_switch(&no_navigation_), "compare obstacles and border only");
  add("robot-radius", text_value("0.3"), "of the robot, a disc, in metres");
  add("ramps", text_value("free"),
      "free: driven across like open ground; avoid: their footprints block");
  add("scans", text_value("200"), "laser scans to compare, from random places free in both maps");
  add("scan-tolerance", text_value("0.05"),
      "ranges that differ by no more, in metres, are the same");
  add("routes", text_value("20"), "shortest paths to compare, between random places");
  add("place", po::value(&places_)->composing(),
      "x,y: compare the routes between each two of these places instead; may be given many times");
  add("min-area", text_value("1"),
      "smallest area, in m², to tell of where the robot can get no more");
  declare_laser_options(options);
  declare_seed(options, "of the random places, a whole number");
  add("jobs", text_value("0"), "threads; 0: as many as the machine has. The answer is the same");
  add("skip-broken", po::bool_switch(&skip_broken_),
      "compare what can be read of a map with defects in its text");
  add("git", po::bool_switch(&git_),
      "take the arguments git gives to an external diff command: PATH OLD-FILE OLD-HEX OLD-MODE "
      "NEW-FILE NEW-HEX NEW-MODE; with --skip-broken, and exit status 0 whatever differs");
  positionals.add("map", -1);
}

void Diff::configure_paths() {
  if (arguments_.size() != 2) {
    fail_usage("diff compares two maps, got " + std::to_string(arguments_.size()));
  }
  old_path_ = arguments_[0];
  new_path_ = arguments_[1];
  if (old_path_ == "-" && new_path_ == "-") fail_usage("standard input can be read once only");
  old_name_ = display_path(old_path_);
  new_name_ = display_path(new_path_);
}

// git(1), GIT_EXTERNAL_DIFF: seven arguments; nine for a file that was renamed; one for a file in
// conflict.
void Diff::configure_git_paths() {
  if (arguments_.size() != 7 && arguments_.size() != 9) {
    fail_usage("--git: git gives 7 arguments, or 9 for a renamed file, got " +
               std::to_string(arguments_.size()));
  }
  old_path_ = arguments_[1];
  new_path_ = arguments_[4];
  old_name_ = "a/" + arguments_[0];
  new_name_ = "b/" + (arguments_.size() == 9 ? arguments_[7] : arguments_[0]);
  skip_broken_ = true;
}

void Diff::configure(const po::variables_map& values) {
  git_ ? configure_git_paths() : configure_paths();
  if (format_ != "text" && format_ != "json" && format_ != "html") {
    fail_usage("--format: '" + format_ + "' is none of text, json, html");
  }
  if (!picture_.empty() && !converter::picture_format(picture_)) {
    fail_usage("--picture: '" + picture_ + "' ends in none of .svg, .png, .pdf");
  }
  options_.tolerance_m = number_option(values, "tolerance", 0.0);
  options_.longest_move_m = positive_option(values, "longest-move");
  configure_navigation(values);
}

void Diff::configure_navigation(const po::variables_map& values) {
  const auto text = [&](const char* name) { return values[name].as<std::string>(); };
  navigation_.robot_radius_m = number_option(values, "robot-radius", 0.0);
  navigation_.scan_tolerance_m = number_option(values, "scan-tolerance", 0.0);
  navigation_.min_area_m2 = number_option(values, "min-area", 0.0);
  navigation_.scans = integer_option(values, "scans", 0, 1'000'000);
  navigation_.routes = integer_option(values, "routes", 0, 1'000'000);
  navigation_.seed = seed_option(values);
  navigation_.threads = static_cast<unsigned>(integer_option(values, "jobs", 0, 1024));
  navigation_.laser = laser_model(values);
  for (const auto& place : places_) navigation_.places.push_back(parse_point("place", place));
  if (navigation_.places.size() == 1) fail_usage("--place: a route needs two places");
  if (text("ramps") != "free" && text("ramps") != "avoid") {
    fail_usage("--ramps: '" + text("ramps") + "' is neither free nor avoid");
  }
  if (text("ramps") == "avoid") navigation_.ramps = navcore::RampPolicy::kAvoid;
}

// What git has no file for is a map without anything.
Map Diff::read(const std::string& path, Console& console) const {
  if (git_ && path == "/dev/null") return {};
  if (!skip_broken_) return read_sound_map_file(path).map;
  MapDocument document = read_map_file(path);
  if (has_errors(document.findings)) {
    console.warning(std::string(display_path(path)) +
                    ": has defects; what could be read of it is compared; 'mapwright validate' "
                    "names them");
  }
  return std::move(document.map);
}

void Diff::compare_navigation(DiffAnswer& answer) const {
  if (no_navigation_) return;
  answer.settings = navigation_;
  answer.settings.focus = boxes_of(answer);
  auto navigation = navcore::diff_navigation(answer.before, answer.after, answer.settings);
  if (navigation) {
    answer.navigation = *std::move(navigation);
  } else {
    answer.navigation_missing = navigation.error().message;
  }
}

void Diff::write(std::ostream& out, const DiffAnswer& answer, bool colour) const {
  if (format_ == "json") return write_diff_json(out, answer);
  if (format_ == "html") return write_diff_html(out, answer);
  write_diff_text(out, answer, colour);
}

ExitStatus Diff::run(Console& console) {
  DiffAnswer answer;
  answer.path_before = old_name_;
  answer.path_after = new_name_;
  answer.before = read(old_path_, console);
  answer.after = read(new_path_, console);
  answer.obstacles = diff_maps(answer.before, answer.after, options_);
  compare_navigation(answer);
  if (!answer.navigation_missing.empty()) {
    console.warning("navigation is not compared: " + answer.navigation_missing);
  }
  if (output_ == "-") {
    write(console.out(), answer, is_colour_terminal(console));
  } else {
    write_file(output_, [&](std::ostream& out) { write(out, answer, false); });
  }
  if (!picture_.empty()) {
    const std::string picture = draw_diff(answer, *converter::picture_format(picture_));
    write_file(picture_, [&](std::ostream& out) { out << picture; });
  }
  return git_ || answer.same() ? ExitStatus::kSuccess : ExitStatus::kNegative;
}

}  // namespace

std::unique_ptr<Verb> make_diff() {
  return std::make_unique<Diff>();
}

}  // namespace mapwright::cli
