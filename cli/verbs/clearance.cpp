#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"
#include "navcore/exact/clearance_table.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;
using Json = nlohmann::ordered_json;
using navcore::ClearanceRow;
using navcore::ClearanceTable;

constexpr std::string_view kDescription =
    R"(Tells how much of a map stays connected as the robot grows. For each radius: the ground its
centre can stand on, in how many parts, the largest of them, its share, and the named places
(name= in a semantic string) that the largest part no longer reaches. Whether two parts are
connected is decided exactly: a gap as wide as the robot lets it pass.

Examples:
  mapwright clearance campus.txt
  mapwright clearance campus.txt --radii 0,0.25,0.3,0.35,0.4
  mapwright clearance campus.txt --ramps avoid --format json
)";

constexpr std::size_t kMostRadii = 1000;

Json row_json(const ClearanceRow& row) {
  Json json;
  json["radius_m"] = row.radius_m;
  json["free_area_m2"] = row.free_area_m2;
  json["components"] = row.components;
  json["largest_area_m2"] = row.largest_area_m2;
  json["share"] = row.share();
  json["places_lost"] = row.places_lost;
  return json;
}

void write_json(std::ostream& out, const ClearanceTable& table) {
  Json json;
  json["schema"] = "mapwright.clearance/1";
  json["places"] = table.places;
  json["rows"] = Json::array();
  for (const auto& row : table.rows) json["rows"].push_back(row_json(row));
  out << json.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

void write_text(std::ostream& out, const ClearanceTable& table) {
  out << "radius m     free m2  parts  largest m2   share  places\n";
  std::size_t reached = table.places;
  for (const auto& row : table.rows) {
    reached -= row.places_lost.size();
    char line[128];
    std::snprintf(line, sizeof line, "%8.3f %11.1f %6zu %11.1f %6.1f%% %7zu", row.radius_m,
                  row.free_area_m2, row.components, row.largest_area_m2, 100.0 * row.share(),
                  reached);
    out << line;
    const char* separator = "  without ";
    for (const auto& name : row.places_lost) {
      out << separator << name;
      separator = ", ";
    }
    out << '\n';
  }
}

class Clearance : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    declare_map_argument(options, positionals, map_path_);
    auto add = options.add_options();
    add("radii", text_value("0,0.1,0.2,0.3,0.4,0.5,0.6,0.8,1,1.5,2"),
        "of the robot, a disc, in metres; 0 for a point");
    add("ramps", text_value("free"),
        "free: driven across like open ground; avoid: their footprints block");
    declare_answer_format(options);
  }

  void configure(const po::variables_map& values) override {
    const std::string ramps = values["ramps"].as<std::string>();
    radii_m_ = parse_numbers("radii", values["radii"].as<std::string>(), 1, kMostRadii);
    for (const double radius_m : radii_m_) {
      if (radius_m < 0.0) fail_usage("--radii: a radius is 0 or greater");
    }
    if (ramps != "free" && ramps != "avoid") {
      fail_usage("--ramps: '" + ramps + "' is neither free nor avoid");
    }
    if (ramps == "avoid") ramps_ = navcore::RampPolicy::kAvoid;
    json_ = json_wanted(values);
  }

  ExitStatus run(Console& console) override {
    const MapDocument document = read_sound_map_file(map_path_);
    const auto table = value_or_throw(navcore::clearance_table(document.map, ramps_, radii_m_));
    (json_ ? write_json : write_text)(console.out(), table);
    return ExitStatus::kSuccess;
  }

 private:
  std::string map_path_;
  std::vector<double> radii_m_;
  navcore::RampPolicy ramps_ = navcore::RampPolicy::kFree;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_clearance() {
  return std::make_unique<Clearance>();
}

}  // namespace mapwright::cli
