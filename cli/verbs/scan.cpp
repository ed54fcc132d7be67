#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/plan/places.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/blind_laser.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/laser_options.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/number_table.hpp"
#include "cli/support/pose_json.hpp"
#include "cli/support/ray_engine.hpp"
#include "cli/verb.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

constexpr std::string_view kDescription =
    R"(Casts the rays of a laser scanner on a map, as a robot at a pose would see it. A wall stops a
ray if it is higher than the laser. Stairs stop a ray at the first step above the laser when seen
from below and not at all when seen from above; a ramp stops it where the surface rises to the laser
(docs/rays.md). What meets nothing reads --max-range.

Rays run from -fov/2 to +fov/2 relative to the heading, counter-clockwise positive; heading 0 looks
along +x, 90 along +y.

Examples:
  mapwright scan campus.txt --pose 40,30,90
  mapwright scan campus.txt --pose 40,30,90 --rays 361 --fov 360 --format json > scan.json
  mapwright render campus.txt -o scan.png --overlay scan.json
  mapwright scan campus.txt --poses poses.csv --noise 0.05 --seed 7 --format json

Exit status 2 if a pose is no place for a robot: outside of the border or in an obstacle.
)";

/// One pose and what the laser reads there.
struct Scan {
  Pose pose;
  std::vector<double> ranges;
};

void write_json(std::ostream& out, const navcore::LaserModel& laser,
                const std::vector<Scan>& scans) {
  Json json;
  json["schema"] = "mapwright.scan/1";
  json["scans"] = Json::array();
  for (const auto& scan : scans) {
    Json entry;
    entry["pose"] = pose_json(scan.pose);
    entry["ranges"] = scan.ranges;
    json["scans"].push_back(std::move(entry));
  }
  json["angles_deg"] = Json::array();
  for (std::size_t i = 0; i < laser.rays; ++i)
    json["angles_deg"].push_back(ray_angle_deg(laser, i));
  json["laser_height"] = laser.height_m;
  json["max_range"] = laser.max_range_m;
  json["fov_deg"] = laser.fov_deg;
  out << json.dump() << '\n';
}

void write_text(std::ostream& out, const navcore::LaserModel& laser,
                const std::vector<Scan>& scans) {
  char line[96];
  for (const auto& scan : scans) {
    std::snprintf(line, sizeof line,
                  "scan from (%.3f, %.3f) heading %.3f: angle in degrees, range in metres\n",
                  scan.pose.x, scan.pose.y, plain_degrees(scan.pose.theta));
    out << line;
    for (std::size_t i = 0; i < laser.rays; ++i) {
      std::snprintf(line, sizeof line, "%9.3f %8.3f\n", ray_angle_deg(laser, i), scan.ranges[i]);
      out << line;
    }
  }
}

class ScanVerb : public Verb {
 public:
  std::string_view synopsis() const override {
    return "MAP (--pose X,Y,DEG | --poses FILE.csv) [OPTIONS]";
  }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  std::vector<Pose> read_poses() const;

  std::string map_path_;
  std::string poses_path_;
  std::optional<Pose> pose_;
  navcore::LaserModel laser_;
  navcore::LaserNoise noise_;
  std::uint64_t seed_ = 1;
  RayEngineKind engine_ = RayEngineKind::kCulled;
  bool json_ = false;
};

void ScanVerb::declare(po::options_description& options,
                       po::positional_options_description& positionals) {
  declare_map_argument(options, positionals, map_path_);
  auto add = options.add_options();
  add("pose", po::value<std::string>(),
      "of the robot: x,y in metres and the heading in degrees, counter-clockwise from +x");
  add("poses", po::value(&poses_path_),
      "a CSV file of many poses, with the columns x,y,theta_deg (metres, degrees)");
  declare_laser_options(options);
  declare_noise_options(options, "noise", "0");
  declare_engine_option(options, "culled");
  declare_seed(options, "of the noise, a whole number");
  declare_answer_format(options);
}

void ScanVerb::configure(const po::variables_map& values) {
  const bool one = values.count("pose") > 0;
  if (one == !poses_path_.empty()) {
    fail_usage("needs either --pose X,Y,DEG or --poses FILE.csv");
  }
  if (one) pose_ = parse_pose("pose", values["pose"].as<std::string>());
  if (poses_path_ == "-" && map_path_ == "-") {
    fail_usage("map and poses cannot both be read from standard input");
  }
  laser_ = laser_model(values);
  noise_ = laser_noise(values, "noise");
  seed_ = seed_option(values);
  engine_ = ray_engine_kind(values);
  json_ = json_wanted(values);
}

std::vector<Pose> ScanVerb::read_poses() const {
  if (pose_) return {*pose_};
  std::vector<Pose> poses;
  for (const auto& row : read_number_table(poses_path_, {"x", "y", "theta_deg"})) {
    poses.push_back({row[0], row[1], Angle::from_degrees(row[2])});
  }
  return poses;
}

ExitStatus ScanVerb::run(Console& console) {
  const MapDocument document = read_sound_map_file(map_path_);
  warn_of_blind_laser(document.map, laser_.height_m, console);
  const std::vector<Pose> poses = read_poses();
  const navcore::FreeSpace space(document.map);
  const RayEngine engine(document.map, engine_);
  std::vector<Scan> scans;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string what = pose_ ? "--pose" : "pose " + std::to_string(i + 1);
    const auto reason = why_not_standing(document.map, space, poses[i].position(), 0.0, what);
    if (reason) fail_usage(*reason);
    Random random(seed_, i);
    scans.push_back({poses[i], perceive(engine.caster(), poses[i], laser_, noise_, random)});
  }
  if (json_) {
    write_json(console.out(), laser_, scans);
  } else {
    write_text(console.out(), laser_, scans);
  }
  return ExitStatus::kSuccess;
}

}  // namespace

std::unique_ptr<Verb> make_scan() {
  return std::make_unique<ScanVerb>();
}

}  // namespace mapwright::cli
