#include <algorithm>
#include <cctype>

#include "cli/localizability/answer_writers.hpp"
#include "cli/localizability/field_layers.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/blind_laser.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/laser_options.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/number_options.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Tells for each place of a map how well a robot can know its position there from one scan: the least
standard deviation that any unbiased estimator can have with this laser, in each direction (the
Cramer-Rao bound), and how likely a scan is mistaken for one of another place that looks the same.
The extension of -o chooses the file: .png, .svg or .pdf a picture, .tif a GeoTIFF with a band for
each quantity, .gpkg the cells and the weak areas as polygons. docs/localizability.md says what the
numbers prove and what they do not.

Areas where a scan tells the position less well than --limit, or where the risk of confusion is
above --risk, are listed: as findings N107 and N108 `mapwright check` tells them too.

--confirm N holds the map against particle filters at N random places: errors seen against errors
predicted, mistakes seen against mistakes predicted; a picture shows the errors seen as discs.

Examples:
  mapwright localizability campus.txt -o localizability.png
  mapwright localizability campus.txt -o localizability.tif --at worst
  mapwright localizability campus.txt -o risk.png --show risk --no-compass
  mapwright localizability campus.txt --format json --confirm 100 > predicted_and_seen.json
)";

constexpr std::size_t kMostPlaces = 20'000'000;

enum class Output { kNone, kPicture, kGeoTiff, kGeoPackage };

Output output_of(const std::string& path) {
  if (path.empty()) return Output::kNone;
  if (converter::picture_format(path)) return Output::kPicture;
  std::string extension = path.substr(std::min(path.size(), path.rfind('.')));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".tif" || extension == ".tiff") return Output::kGeoTiff;
  if (extension == ".gpkg") return Output::kGeoPackage;
  fail_usage("-o: '" + path + "' ends in none of .png, .svg, .pdf, .tif, .gpkg");
}

Shown parse_shown(const std::string& text) {
  if (text == "accuracy") return Shown::kAccuracy;
  if (text == "edges") return Shown::kEdges;
  if (text == "heading") return Shown::kHeading;
  if (text == "risk") return Shown::kRisk;
  fail_usage("--show: '" + text + "' is none of accuracy, edges, heading, risk");
}

class Localizability : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP [-o FILE] [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }
  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void configure_field(const po::variables_map& values);
  void write_output(const MapDocument& document, const LocalizabilityAnswer& answer,
                    const std::optional<Georeference>& georeference) const;
  void draw(const Map& map, const LocalizabilityAnswer& answer,
            const std::optional<Georeference>& georeference) const;
  std::string picture_title() const;

  std::string map_path_, output_;
  Output kind_ = Output::kNone;
  navcore::LocalizabilitySettings settings_;
  navcore::WeaknessLimits limits_;
  navcore::ConfirmationSettings confirmation_;
  AtHeading at_ = AtHeading::kMedian;
  Shown shown_ = Shown::kAccuracy;
  int width_px_ = 1600;
  bool json_ = false;
};

void Localizability::declare(po::options_description& options,
                             po::positional_options_description& positionals) {
  declare_map_argument(options, positionals, map_path_);
  auto add = options.add_options();
  add("output,o", po::value(&output_), "the file to write: .png, .svg, .pdf, .tif or .gpkg");
  add("cell", text_value("0.5"), "side of the cells, in metres");
  add("bbox", po::value<std::string>(),
      "part to look at: x1,y1,x2,y2 in metres (default: the map's border)");
  add("robot-radius", text_value("0"),
      "places where a disc of this radius fits, in metres; 0: a point");
  declare_laser_options(options);
  add("laser-noise", text_value("0.05"), "standard deviation of a range, in metres");
  add("occlusion", text_value("0.1"),
      "share of the beams, from 0 to below 1, whose range says nothing of the map: people, cars, "
      "what the map lacks");
  add("headings", text_value("16"), "headings of the robot to look at, over a full turn");
  add("heading", po::value<std::string>(), "this heading of the robot only, in degrees");
  add("at", text_value("median"),
      "what files show: at the median or the worst of a place's headings");
  add("compass-error", text_value("3"),
      "standard deviation of the compass, in degrees: it tells places "
      "apart that look the same in different directions");
  add("no-compass", "the heading is not known");
  add("apart", text_value("2"), "what is nearer than this, in metres, is no other place");
  add("no-twins", "do not look for places that look the same");
  add("limit", text_value("1"),
      "areas where a scan tells the position less well, in metres (N107)");
  add("risk", text_value("0.1"), "areas where the risk of confusion is greater, 0 to 0.5 (N108)");
  add("min-area", text_value("10"), "smallest of these areas, in m²");
  add("show", text_value("accuracy"),
      "what a picture shows: accuracy, edges (accuracy where edges of things count), heading or "
      "risk");
  add("width", text_value("1600"), "width of a PNG in pixels, 200 to 20000");
  add("confirm", text_value("0"), "hold the map against particle filters at so many random places");
  add("confirm-runs", text_value("20"),
      "with --confirm: runs of the tracking filter at each place");
  declare_seed(options, "with --confirm: of the random numbers, a whole number");
  declare_threads(options);
  declare_answer_format(options);
}

void Localizability::configure_field(const po::variables_map& values) {
  settings_.cell_m = positive_option(values, "cell");
  if (values.count("bbox") > 0) {
    const auto n = parse_numbers("bbox", values["bbox"].as<std::string>(), 4, 4);
    settings_.window = Box{n[0], n[1], n[2], n[3]};
    if (!(settings_.window->width() > 0.0 && settings_.window->height() > 0.0)) {
      fail_usage("--bbox: x1 must be less than x2 and y1 less than y2");
    }
  }
  settings_.robot_radius_m = number_option(values, "robot-radius", 0.0);
  settings_.laser = laser_model(values);
  settings_.noise = {positive_option(values, "laser-noise"),
                     number_option(values, "occlusion", 0.0, 0.99)};
  settings_.headings = integer_option(values, "headings", 1, 720);
  if (values.count("heading") > 0) {
    settings_.heading_deg = parse_number("heading", values["heading"].as<std::string>());
  }
  settings_.compass_sigma_deg = positive_option(values, "compass-error");
  if (values.count("no-compass") > 0) settings_.compass_sigma_deg.reset();
  settings_.apart_m = positive_option(values, "apart");
  settings_.look_for_twins = values.count("no-twins") == 0;
  settings_.threads = threads_option(values);
}

void Localizability::configure(const po::variables_map& values) {
  kind_ = output_of(output_);
  configure_field(values);
  limits_.accuracy_m = positive_option(values, "limit");
  limits_.risk = number_option(values, "risk", 0.0, 0.5);
  limits_.min_area_m2 = number_option(values, "min-area", 0.0);
  const std::string at = values["at"].as<std::string>();
  if (at != "worst" && at != "median") fail_usage("--at: '" + at + "' is neither worst nor median");
  at_ = at == "worst" ? AtHeading::kWorst : AtHeading::kMedian;
  shown_ = parse_shown(values["show"].as<std::string>());
  if (shown_ == Shown::kRisk && !settings_.look_for_twins) {
    fail_usage("--show risk and --no-twins exclude each other");
  }
  width_px_ = static_cast<int>(integer_option(values, "width", 200, 20000));
  confirmation_.places = integer_option(values, "confirm", 0, 100'000);
  confirmation_.runs = integer_option(values, "confirm-runs", 1, 10'000);
  confirmation_.seed = seed_option(values);
  json_ = json_wanted(values);
}

std::string Localizability::picture_title() const {
  const std::string heading = settings_.heading_deg      ? "one heading"
                              : at_ == AtHeading::kWorst ? "worst heading"
                                                         : "median heading";
  switch (shown_) {
    case Shown::kAccuracy:
      return "Least standard deviation of the position from one scan (" + heading + ")";
    case Shown::kEdges:
      return "Standard deviation of the position from one scan, with edges (" + heading + ")";
    case Shown::kHeading:
      return "Least standard deviation of the heading from one scan (" + heading + ")";
    case Shown::kRisk:
      return std::string("Least share of scans mistaken for the most similar other place (") +
             heading + (settings_.compass_sigma_deg ? ")" : ", no compass)");
  }
  return {};
}

void Localizability::draw(const Map& map, const LocalizabilityAnswer& answer,
                          const std::optional<Georeference>& georeference) const {
  converter::PictureOptions options;
  options.title = picture_title();
  options.window = settings_.window;
  options.width_px = width_px_;
  options.labels = converter::PictureLabels::kNone;
  options.orientation_ticks = false;
  if (georeference) options.north_deg = 90.0 + georeference->heading_deg;
  auto overlay = field_overlay(answer.field, at_, shown_, limits_.accuracy_m);
  const bool positions = shown_ == Shown::kAccuracy || shown_ == Shown::kEdges;
  if (answer.confirmation && positions) add_seen(*answer.confirmation, overlay);
  const std::string picture =
      value_or_throw(draw_picture(map, overlay, options, *converter::picture_format(output_)));
  write_file(output_, [&](std::ostream& out) { out << picture; });
}

void Localizability::write_output(const MapDocument& document, const LocalizabilityAnswer& answer,
                                  const std::optional<Georeference>& georeference) const {
  if (kind_ == Output::kPicture) return draw(document.map, answer, georeference);
  const converter::Field bands = field_bands(answer.field, at_);
  TemporaryFile file(output_);
  if (kind_ == Output::kGeoTiff) {
    value_or_throw(converter::write_field_geotiff(bands, georeference, file.path()));
  } else {
    value_or_throw(converter::write_field_geopackage(
        bands, {weak_area_layer(answer.field, answer.areas, bands)}, georeference, file.path()));
  }
  file.commit();
}

// Statistics of no place at all would read like those of a perfect map.
void require_places(const navcore::LocalizabilityField& field) {
  const bool any = std::any_of(field.stands.begin(), field.stands.end(),
                               [](auto stands) { return stands != 0; });
  if (any) return;
  fail_usage(
      "there is no place to look at: the robot stands in the middle of no cell; choose a smaller "
      "--cell, another --bbox or a smaller --robot-radius");
}

ExitStatus Localizability::run(Console& console) {
  const MapDocument document = read_sound_map_file(map_path_);
  auto georeference = read_sidecar(map_path_);
  if (!georeference) {
    throw Error(ExitStatus::kInput, sidecar_path(map_path_) + ": " + georeference.error().message);
  }
  if (navcore::place_count(document.map, settings_) > kMostPlaces) {
    fail_usage("--cell: more than 20 million cells; choose larger ones, or a part with --bbox");
  }
  warn_of_blind_laser(document.map, settings_.laser.height_m, console);
  const navcore::FreeSpace space(document.map);
  const auto field = navcore::localizability_field(document.map, space, settings_,
                                                   console.progress("localizability"));
  require_places(field);
  LocalizabilityAnswer answer{settings_,
                              limits_,
                              field,
                              navcore::summary_of(field, limits_),
                              navcore::weak_areas(field, limits_),
                              {},
                              output_};
  if (confirmation_.places > 0) {
    answer.confirmation = navcore::confirm(document.map, space, field, settings_, confirmation_,
                                           console.progress("filters"));
  }
  if (kind_ != Output::kNone) {
    write_output(document, answer, *georeference);
    console.note("wrote " + output_);
  }
  (json_ ? write_localizability_json : write_localizability_text)(console.out(), answer);
  return ExitStatus::kSuccess;
}

}  // namespace

std::unique_ptr<Verb> make_localizability() {
  return std::make_unique<Localizability>();
}

}  // namespace mapwright::cli
