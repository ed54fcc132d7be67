#include <optional>

#include "cli/plan/answer_writers.hpp"
#include "cli/plan/query_file.hpp"
#include "cli/plan/solver.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/number_options.hpp"
#include "cli/support/planners.hpp"
#include "cli/verb.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Plans a robot's path on a map, from a start to a goal, around everything higher than 0.
Stairs always block; ramps are driven across like open ground unless --ramps says otherwise. The
robot is a point, or a disc with --radius. The answer is a path that meets nothing over its whole
length, its length, and how near it comes to an obstacle; or the reason why there is none.

Start, goal and --via may be names: of a place, that is of obstacles whose semantic string holds
name=NAME (docs/format.md). A bench or a building is itself solid, so the robot is sent to free
ground beside it: as near as it fits, in front of the middle of its longest side if that is free,
and where the largest connected area reaches it. The answer says which point was taken.

A random planner that finds no path proves nothing: the answer says "proved" where the map was
shown to have no way for the robot.

Examples:
  mapwright plan campus.txt --start 5,5 --goal 80,60
  mapwright plan campus.txt --start 5,5 --goal 80,60 --radius 0.3 --planner rrt --seed 7
  mapwright plan campus.txt --start 5,5 --goal 80,60 --via 40,20 --via ramp:12
  mapwright plan campus.txt --start Library --goal "Bench 4" --planner exact --radius 0.3
  mapwright plan campus.txt --queries pairs.csv --format json > paths.json
  mapwright plan campus.txt --start 5,5 --goal 80,60 --with-tree --format json > plan.json
  mapwright render campus.txt -o plan.png --overlay plan.json

Exit status 1 if one of the queries has no answer.
)";

// Cautions are about the map, so the same for all queries.
void warn_once(const std::vector<PlanAnswer>& answers, Console& console) {
  for (const auto& answer : answers) {
    if (answer.route.total.caution.empty()) continue;
    return console.warning(answer.route.total.caution);
  }
}

class Plan : public Verb {
 public:
  std::string_view synopsis() const override {
    return "MAP (--start X,Y|NAME --goal X,Y|NAME | --queries FILE.csv) [OPTIONS]";
  }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void configure_queries(const po::variables_map& values);
  void configure_ramps(const std::string& word);
  void configure_smoothing(const po::variables_map& values);

  std::string map_path_;
  std::optional<StartAndGoal> query_;
  std::string queries_path_;
  PlanSettings settings_;
  unsigned jobs_ = 1;
  bool with_tree_ = false;
  bool json_ = false;
};

void Plan::declare(po::options_description& options,
                   po::positional_options_description& positionals) {
  static const std::string planner_help = "one of " + planner_names();
  declare_map_argument(options, positionals, map_path_);
  auto add = options.add_options();
  add("start", po::value<std::string>(),
      "where the robot is: x,y in metres, or the name of a place");
  add("goal", po::value<std::string>(), "where it is to go: x,y in metres, or the name of a place");
  add("queries", po::value(&queries_path_),
      "a CSV file of many queries, with the columns start_x,start_y,goal_x,goal_y in metres, or "
      "start,goal with names of places");
  add("planner", po::value(&settings_.planner)->default_value("balanced-rrt"),
      planner_help.c_str());
  add("radius", text_value("0"), "of the robot, a disc, in metres; 0 for a point");
  add("ramps", text_value("free"),
      "free: driven across like open ground; avoid: their footprints block; force: the path must "
      "cross one, the shortest way is taken");
  add("via", po::value<std::vector<std::string>>()->composing(),
      "a place the path must pass, x,y in metres, a name or ramp:ID; may be given several times, "
      "in order");
  add("via-ramp", po::value<std::vector<std::string>>()->composing(),
      "id of a ramp the path must cross, after all --via places; may be given several times");
  declare_seed(options, "of the random numbers, a whole number");
  add("max-iterations", text_value("100000"),
      "random points a planner draws, on each leg, before it gives up");
  add("max-extension", text_value("0"),
      "longest edge of a random tree in metres; 0: no limit, as in the report. 20 makes planning "
      "on "
      "a map of a kilometre several times faster");
  add("goal-bias", text_value("0"),
      "share of the random points, from 0 to below 1, that are the goal");
  add("smooth", "shorten the paths of random planners (the default)");
  add("no-smooth", "leave them as they are");
  add("smooth-clearance", text_value("0"),
      "what shortcuts keep away from obstacles beyond the radius, in metres");
  add("jobs", text_value("1"),
      "threads for many queries; 0: as many as the machine has. The answer is the same");
  add("with-tree", "put search trees and paths before smoothing into the JSON answer");
  declare_answer_format(options);
}

void Plan::configure(const po::variables_map& values) {
  configure_queries(values);
  find_planner(settings_.planner);
  settings_.seed = seed_option(values);
  settings_.rrt.max_iterations = integer_option(values, "max-iterations", 1, 1'000'000'000);
  jobs_ = static_cast<unsigned>(integer_option(values, "jobs", 0, 1024));
  settings_.radius_m = number_option(values, "radius", 0.0);
  settings_.rrt.max_extension_m = number_option(values, "max-extension", 0.0);
  settings_.rrt.goal_bias = number_option(values, "goal-bias", 0.0, 1.0);
  if (settings_.rrt.goal_bias == 1.0) fail_usage("--goal-bias: must be below 1");
  for (const char* name : {"via", "via-ramp"}) {
    if (values.count(name) == 0) continue;
    for (const auto& text : values[name].as<std::vector<std::string>>()) {
      settings_.via.push_back(parse_via(name, name == std::string("via") ? text : "ramp:" + text));
    }
  }
  configure_ramps(values["ramps"].as<std::string>());
  configure_smoothing(values);
  with_tree_ = values.count("with-tree") > 0;
  json_ = json_wanted(values);
  if (with_tree_ && !json_) fail_usage("--with-tree: needs --format json");
}

void Plan::configure_queries(const po::variables_map& values) {
  const bool start = values.count("start") > 0;
  const bool goal = values.count("goal") > 0;
  if (!queries_path_.empty()) {
    if (start || goal) fail_usage("--queries excludes --start and --goal");
    if (queries_path_ == "-" && map_path_ == "-") {
      fail_usage("map and queries cannot both be read from standard input");
    }
    return;
  }
  if (!start || !goal)
    fail_usage("needs --start X,Y and --goal X,Y (or names), or --queries FILE.csv");
  query_ = StartAndGoal{parse_place("start", values["start"].as<std::string>()),
                        parse_place("goal", values["goal"].as<std::string>())};
}

void Plan::configure_ramps(const std::string& word) {
  if (word != "free" && word != "avoid" && word != "force") {
    fail_usage("--ramps: '" + word + "' is none of free, avoid, force");
  }
  settings_.force_ramp = word == "force";
  if (word != "avoid") return;
  settings_.ramps = navcore::RampPolicy::kAvoid;
  for (const auto& via : settings_.via) {
    if (via.ramp) fail_usage("--ramps avoid excludes a ramp to pass");
  }
}

void Plan::configure_smoothing(const po::variables_map& values) {
  if (values.count("smooth") > 0 && values.count("no-smooth") > 0) {
    fail_usage("--smooth and --no-smooth exclude each other");
  }
  settings_.smoothing->extra_clearance_m = number_option(values, "smooth-clearance", 0.0);
  if (values.count("no-smooth") > 0) settings_.smoothing.reset();
}

ExitStatus Plan::run(Console& console) {
  const MapDocument document = read_sound_map_file(map_path_);
  std::vector<StartAndGoal> queries;
  if (query_) queries.push_back(*query_);
  if (!queries_path_.empty()) queries = read_queries(queries_path_);
  const PlanSolver solver(document.map, settings_);
  for (auto& query : queries) query = solver.located(query);
  std::vector<PlanAnswer> answers(queries.size());
  const auto solve = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = solver.answer(queries[i], i);
  };
  navcore::parallel_for(queries.size(), 1, jobs_, solve);
  if (json_) {
    write_plan_json(console.out(), settings_, answers, with_tree_);
  } else {
    write_plan_text(console.out(), answers);
  }
  warn_once(answers, console);
  for (const auto& answer : answers) {
    if (!answer.route.total.solved) return ExitStatus::kNegative;
  }
  return ExitStatus::kSuccess;
}

}  // namespace

std::unique_ptr<Verb> make_plan() {
  return std::make_unique<Plan>();
}

}  // namespace mapwright::cli
