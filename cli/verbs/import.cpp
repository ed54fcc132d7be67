#include <algorithm>
#include <filesystem>

#include "cli/convert/converted_files.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/number_options.hpp"
#include "cli/support/number_table.hpp"
#include "cli/verb.hpp"
#include "converter/importers/imported_map.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Turns what other robots' programs call a map into a map of this program's:

  lines.csv   a table of line segments, columns ax,ay,bx,by in metres (others are passed over): each
              line becomes a wall that is free on both sides
  grid.yaml   an occupancy grid of a map server (ROS map_server, nav2), with the PGM, PNG or BMP
              image it names: outlines of the occupied cells become polygons, what they enclose inner
              rings. Unknown cells count as free: nobody has seen a wall there

Outlines of a grid are simplified: every point of the map lies within --simplify plus 0.36 cells of
the outlines of the occupied cells. The map is in plain metres of the source's own frame. It is read
back and validated before it gets its name.

Exit status: 0 the map is written and valid; 1 it is written but validation finds errors, or nothing
was written because the source holds no wall; 3 the source cannot be read.

Examples:
  mapwright import lines.csv -o map.txt
  mapwright import floor.yaml -o map.txt --simplify 0.1 --smallest-area 0.01
)";

enum class SourceKind { kLines, kGrid };

std::optional<SourceKind> kind_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".csv") return SourceKind::kLines;
  if (extension == ".yaml" || extension == ".yml") return SourceKind::kGrid;
  return std::nullopt;
}

class Import : public Verb {
 public:
  std::string_view synopsis() const override { return "LINES.csv|GRID.yaml -o MAP.txt [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    auto add = options.add_options();
    add("source", po::value(&source_)->required(), "table of lines or grid");
    add("output,o", po::value(&output_)->required(), "the map; - writes standard output");
    add("height", text_value("2"), "of all segments, in metres: such sources give none");
    add("outdoor", "segments are marked outdoor, not indoor");
    add("margin", text_value("1"),
        "metres from everything to the map's border, rounded up to whole ones");
    add("simplify", text_value("0.05"),
        "grids: metres that an outline may move; 0 keeps all its corners");
    add("smallest-area", text_value("0"),
        "grids: outlines around less are left out, square metres");
    positionals.add("source", 1);
  }

  void configure(const po::variables_map& values) override {
    const auto kind = kind_of(source_);
    if (!kind) fail_usage("'" + source_ + "' ends in none of .csv, .yaml, .yml");
    kind_ = *kind;
    options_.height_m = positive_option(values, "height", tolerance::kAbsurdHeight_m);
    options_.in_out = values.count("outdoor") > 0 ? InOut::kOutdoor : InOut::kIndoor;
    options_.border_margin_m = number_option(values, "margin", 0.0, 1e4);
    options_.simplification_m = number_option(values, "simplify", 0.0, 100.0);
    options_.smallest_area_m2 = number_option(values, "smallest-area", 0.0);
  }

  ExitStatus run(Console& console) override {
    ConvertedFiles files(output_, "");
    const Map map = kind_ == SourceKind::kGrid ? grid_map() : line_map(console);
    if (map.obstacles.empty()) {
      console.error("no map is written: '" + source_ + "' holds no wall");
      return ExitStatus::kNegative;
    }
    const auto findings = files.write_map(map, tolerance::kResolution_m, console);
    files.write_sidecar(std::nullopt);
    files.commit_map();
    report_findings(console, output_, findings);
    console.note(output_ + ": " + std::to_string(map.obstacles.size()) + " obstacles, " +
                 std::to_string(segment_count(map)) + " segments, " +
                 std::to_string(findings.size()) + " findings");
    return has_errors(findings) ? ExitStatus::kNegative : ExitStatus::kSuccess;
  }

 private:
  Map grid_map() const {
    return grid_to_map(value_or_throw(converter::read_grid_map(source_)), options_);
  }

  Map line_map(Console& console) const {
    std::vector<converter::Line> lines;
    for (const auto& row : read_number_table(source_, {"ax", "ay", "bx", "by"})) {
      lines.push_back({{row[0], row[1]}, {row[2], row[3]}});
    }
    Map map = lines_to_map(lines, options_);
    const std::size_t left_out = lines.size() - map.obstacles.size();
    if (left_out > 0) {
      console.warning(source_ + ": " + std::to_string(left_out) +
                      " lines without length are left out");
    }
    return map;
  }

  std::string source_, output_;
  SourceKind kind_ = SourceKind::kLines;
  converter::ImportOptions options_;
};

}  // namespace

std::unique_ptr<Verb> make_import() {
  return std::make_unique<Import>();
}

}  // namespace mapwright::cli
