#include <filesystem>

#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/frame_options.hpp"
#include "cli/support/number_options.hpp"
#include "cli/verb.hpp"
#include "converter/authoring/site_template.hpp"
#include "converter/authoring/template_layers.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Makes an empty GeoPackage to draw a site in with QGIS or another GIS editor: layers for border,
buildings, furniture, walls, stairs, steps and ramps; fields with defaults, value lists and limits;
QGIS styles that show which side of a wall is free, where stairs and ramps lead, heights and kinds.

Its coordinates are metres around the origin, true on the ground (a transverse Mercator projection
of its own), unless --crs names another CRS. Where the map is to lie, and how it is turned, stands in
the fields of the border, so that what is drawn converts without options:

  mapwright new site.gpkg --origin 41.3890,2.1130 --heading -20
  (draw)
  mapwright convert site.gpkg -o site.txt

An existing file is not touched unless --overwrite is given.

Examples:
  mapwright new site.gpkg --origin 41.3890,2.1130 --size 300,200
  mapwright new site.gpkg --origin 425800,4582230 --origin-crs EPSG:25831 --crs EPSG:25831
)";

class New : public Verb {
 public:
  std::string_view synopsis() const override { return "SITE.gpkg --origin LAT,LON [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    options.add_options()("site", po::value(&path_)->required(), "the GeoPackage to make");
    frame_.declare(options, "required");
    auto add = options.add_options();
    add("crs", po::value(&crs_),
        "CRS to draw in, such as EPSG:25831 (default: metres around the origin)");
    add("size", po::value(&size_)->default_value("200,200"),
        "WIDTH,HEIGHT of the border to begin with, in metres along the map's axes, the origin in "
        "its middle");
    add("resolution", text_value("0.001"), "metres that the map's coordinates will be rounded to");
    add("overwrite", po::bool_switch(&overwrite_), "replace an existing file");
    positionals.add("site", 1);
  }

  void configure(const po::variables_map& values) override {
    const auto frame = frame_.parse();
    if (frame.origin.empty()) fail_usage("--origin LAT,LON is missing: where is the site?");
    if (std::filesystem::path(path_).extension() != ".gpkg") {
      fail_usage(path_ + ": the template is a GeoPackage: give it a name that ends in .gpkg");
    }
    site_.georeference = value_or_throw(converter::resolve_frame(frame, 0.0, 0.0));
    if (!crs_.empty()) site_.crs = drawing_crs();
    const auto size = parse_numbers("size", size_, 2, 2);
    if (!(size[0] > 0.0 && size[1] > 0.0)) fail_usage("--size: both must be greater than 0");
    site_.width_m = size[0];
    site_.height_m = size[1];
    site_.resolution_m = number_option(values, "resolution", 1e-9, 10.0);
  }

  ExitStatus run(Console& console) override {
    if (!overwrite_ && std::filesystem::exists(path_)) {
      throw Error(ExitStatus::kOutput,
                  path_ +
                      ": is there already, and may hold a drawing: choose another name, or "
                      "--overwrite");
    }
    TemporaryFile file(path_);
    std::filesystem::remove(file.path());
    value_or_throw(converter::write_site_template(file.path(), site_));
    file.commit();
    console.note(path_ + ": " + std::to_string(converter::template_layers().size()) +
                 " layers to draw in; convert it with: mapwright convert " + path_ + " -o MAP.txt");
    return ExitStatus::kSuccess;
  }

 private:
  converter::Crs drawing_crs() const {
    auto crs = converter::parse_crs(crs_);
    if (!crs) fail_usage("--crs: " + crs.error().message);
    return *std::move(crs);
  }

  std::string path_, crs_, size_;
  FrameArguments frame_;
  bool overwrite_ = false;
  converter::SiteTemplate site_;
};

}  // namespace

std::unique_ptr<Verb> make_new() {
  return std::make_unique<New>();
}

}  // namespace mapwright::cli
