#include "cli/convert/conversion_summary.hpp"
#include "cli/convert/convert_arguments.hpp"
#include "cli/convert/converted_files.hpp"
#include "cli/convert/source_watch.hpp"
#include "cli/support/error.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"
#include "converter/ledger/obstacle_sources.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Turns GIS vector layers into a map a robot can navigate by, with a sidecar MAP.georef.json that
ties it to the Earth. Sources are Shapefile (a file or a folder of them), GeoPackage, GeoJSON,
FlatGeobuf, KML, GML, DXF, OSM, CSV and MapInfo files; they are never changed. Several sources and
layers make one map. Coordinates go from each layer's CRS by way of WGS 84 to metres around --origin.

Every feature is written, changed or dropped with a reason; --report lists them. The map is read back
and validated before it gets its name.

Exit status: 0 the map is written and valid; 1 it is written but validation finds errors, or nothing
was written because nothing became an obstacle or --strict found repairs; 2 wrong usage; 3 a source
cannot be read whole or states no CRS; 4 an output cannot be written. With 2, 3 and 4 no map is
written.

Examples:
  mapwright convert campus.gpkg -o campus.txt
  mapwright convert walls.shp stairs.shp -o site.txt --origin 41.389,2.113 --report ledger.json
  mapwright convert shp/ -o campus.txt --origin 425800,4582230 --origin-crs EPSG:25831 --heading -20
  mapwright convert plan.dxf -o hall.txt --local --rules hall.yaml
  mapwright convert --explain-rules campus.gpkg
  mapwright convert site.gpkg -o site.txt --watch      (beside a GIS editor)
)";

class Convert : public Verb {
 public:
  std::string_view synopsis() const override { return "SOURCE... -o MAP.txt [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    arguments_.declare(options, positionals);
  }

  void configure(const po::variables_map& values) override { arguments_.check(values); }

  ExitStatus run(Console& console) override {
    if (arguments_.explains_rules()) {
      console.out() << value_or_throw(converter::explain_rules(arguments_.options()));
      return ExitStatus::kSuccess;
    }
    return arguments_.watches() ? watch(console) : convert_once(console);
  }

 private:
  // Until the user interrupts: a drawing that cannot be converted now can be mended and saved.
  [[noreturn]] ExitStatus watch(Console& console) {
    SourceWatch sources(arguments_.sources(), arguments_.outputs());
    while (true) {
      try {
        convert_once(console);
      } catch (const Error& error) {
        console.error(error.what());
      }
      console.note("watching for changes; Ctrl+C ends");
      sources.wait_for_change();
    }
  }

  ExitStatus convert_once(Console& console) const {
    auto options = arguments_.options();
    ConvertedFiles files(arguments_.output(), arguments_.report());
    options.progress = console.progress("converting");
    auto conversion = value_or_throw(converter::convert(options));
    report_conversion(conversion, console);
    files.write_report(conversion.ledger, console);
    if (const auto refused = refusal(conversion, console)) return *refused;
    const auto status = write(conversion, files, console);
    if (!arguments_.watches()) {
      keep_to_the_end(std::make_shared<converter::Conversion>(std::move(conversion)));
    }
    return status;
  }

  // Why no map is written although the sources could be read.
  std::optional<ExitStatus> refusal(const converter::Conversion& conversion,
                                    Console& console) const {
    const auto lost = report_losses(conversion.ledger, console);
    if (lost > 0 && !arguments_.keeps_broken()) {
      console.error("no map is written: features are lost; --skip-broken goes on without them");
      return ExitStatus::kInput;
    }
    if (arguments_.is_strict() && report_repairs(conversion.ledger, console) > 0) {
      console.error("no map is written: --strict allows no repair");
      return ExitStatus::kNegative;
    }
    if (conversion.map.is_empty()) {
      console.error(
          "no map is written: nothing in the sources becomes an obstacle; "
          "--explain-rules says what the rules make of them");
      return ExitStatus::kNegative;
    }
    return std::nullopt;
  }

  // Lets the map go.
  ExitStatus write(converter::Conversion& conversion, ConvertedFiles& files,
                   Console& console) const {
    const bool is_incomplete = conversion.is_incomplete || has_losses(conversion.ledger);
    const std::string size = std::to_string(conversion.map.obstacle_count()) + " obstacles, " +
                             std::to_string(conversion.map.segment_count()) + " segments";
    auto findings = files.write_map(std::move(conversion.map), conversion.resolution_m, console,
                                    !arguments_.watches());
    if (!findings.empty()) {
      converter::ObstacleSources(conversion.ledger, findings).name_features(findings);
    }
    files.write_sidecar(conversion.georeference);
    files.commit_map();
    report_findings(console, arguments_.output(), findings);
    console.note(arguments_.output() + ": " + size + ", " + std::to_string(findings.size()) +
                 " findings");
    if (has_errors(findings)) {
      console.error(arguments_.output() + ": the map is written, but it is not valid");
      return ExitStatus::kNegative;
    }
    return is_incomplete ? ExitStatus::kNegative : ExitStatus::kSuccess;
  }

  static bool has_losses(const converter::Ledger& ledger) {
    for (const auto position : ledger.explained()) {
      for (const auto& reason : ledger.features[position].reasons) {
        if (finding_type(reason.code).severity == Severity::kError) return true;
      }
    }
    return false;
  }

  ConvertArguments arguments_;
};

}  // namespace

std::unique_ptr<Verb> make_convert() {
  return std::make_unique<Convert>();
}

}  // namespace mapwright::cli
