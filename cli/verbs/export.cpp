#include <filesystem>

#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"
#include "converter/exporters/export_map.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Writes a map as GIS layers, or as an occupancy grid. The extension of -o chooses the format:
)";

constexpr std::string_view kMore = R"(
GIS layers: solids with their courtyards are polygons, walls and single steps lines, ramps and the
border polygons; id, heights, in/out, shape and every token of the semantic strings are fields.
Coordinates are in the CRS that the map's sources had (sidecar MAP.georef.json), or in --crs; without
a sidecar in metres of the map's own frame. Edit the layers, and `mapwright convert X` makes the map
again: what was not edited comes back as it was, to the byte (docs/round-trip.md).

Occupancy grid: cells that a segment touches are occupied, the inside of solids is unknown, all else
within the border is free. The origin is the border's lower left corner, x and y are the map's.

Files appear under their names only when all are complete.

Examples:
  mapwright export campus.txt -o campus.gpkg
  mapwright export campus.txt -o campus.shp --crs EPSG:25831
  mapwright export campus.txt -o campus.yaml --resolution 0.05 --laser-height 0.4
)";

std::string described() {
  std::string text(kDescription);
  for (const auto& exporter : converter::exporters()) {
    std::string extension(exporter.extension);
    extension.resize(10, ' ');
    text += "  " + extension + std::string(exporter.summary) + "\n";
  }
  return text + std::string(kMore);
}

std::string known_extensions() {
  std::string all;
  for (const auto& exporter : converter::exporters()) {
    all += (all.empty() ? "" : ", ") + std::string(exporter.extension);
  }
  return all;
}

class Export : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP -o FILE [OPTIONS]"; }
  std::string_view description() const override { return description_; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    declare_map_argument(options, positionals, map_path_);
    auto add = options.add_options();
    add("output,o", po::value(&output_)->required(), "the file to write; see above");
    add("crs", po::value(&crs_),
        "CRS of GIS layers: EPSG:CODE, WKT, or map for metres of the map's frame (default: that of "
        "the map's sources; GeoJSON and KML: longitude and latitude; DXF: map)");
    add("resolution", po::value(&resolution_)->default_value("0.05"),
        "of an occupancy grid: side of a cell in metres, 0.001 to 100");
    add("laser-height", po::value(&laser_height_)->default_value("0"),
        "of an occupancy grid: metres above the ground; only what is higher occupies cells. 0 "
        "shows "
        "all that stops a robot, steps of stairs included; a laser's height what it sees");
  }

  void configure(const po::variables_map& values) override {
    exporter_ = converter::exporter_for(output_);
    if (exporter_ == nullptr) {
      fail_usage("-o: '" + output_ + "' ends in none of " + known_extensions());
    }
    const bool is_grid = exporter_->extension == ".yaml";
    if (!is_grid && !(values["resolution"].defaulted() && values["laser-height"].defaulted())) {
      fail_usage("--resolution and --laser-height are about occupancy grids (-o X.yaml)");
    }
    grid_.cell_m = parse_number("resolution", resolution_);
    if (grid_.cell_m < 0.001 || grid_.cell_m > 100.0) {
      fail_usage("--resolution: expected metres from 0.001 to 100, got " + resolution_);
    }
    grid_.above_m = parse_number("laser-height", laser_height_);
    if (grid_.above_m < 0.0) fail_usage("--laser-height: must not be below 0");
  }

  ExitStatus run(Console& console) override {
    const MapDocument document = read_sound_map_file(map_path_);
    auto georeference = read_sidecar(map_path_);
    if (!georeference) {
      throw Error(ExitStatus::kInput,
                  sidecar_path(map_path_) + ": " + georeference.error().message);
    }
    TemporaryFolder folder(output_);
    const converter::ExportJob job{
        document.map, *std::move(georeference), crs_, grid_, folder.path(), stem()};
    const auto exported = value_or_throw(exporter_->run(job));
    for (const auto& warning : exported.warnings) console.warning(output_ + ": " + warning);
    folder.commit(exported.files);
    const auto target_folder = std::filesystem::path(output_).parent_path();
    std::string files;
    for (const auto& file : exported.files) {
      files += (files.empty() ? "" : ", ") + (target_folder / file).string();
    }
    console.note("wrote " + files);
    return ExitStatus::kSuccess;
  }

 private:
  std::string stem() const { return std::filesystem::path(output_).stem().string(); }

  std::string description_ = described();
  std::string map_path_, output_, crs_, resolution_, laser_height_;
  const converter::Exporter* exporter_ = nullptr;
  converter::GridOptions grid_;
};

}  // namespace

std::unique_ptr<Verb> make_export() {
  return std::make_unique<Export>();
}

}  // namespace mapwright::cli
