#include "mapcore/parts/crop.hpp"
#include "cli/convert/converted_files.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"
#include "mapcore/text/map_resolution.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Writes a part of a map: the obstacles that touch a box or a disc, with their ids and in their order,
and the sidecar beside it. An outline comes with all its courtyards. The border is the box (of a disc:
the box around it) within the map's border.

Obstacles stay whole, so that the parts of a map merge to the map again ('mapwright merge'); those
that reach beyond the part's border are findings G109 to 'validate'. --cut clips outlines and walls
at the box instead: a solid's new edges have its height and are labelled "cut"; stairs and ramps stay
whole. Such parts are valid by themselves but for those. Their pieces carry the whole obstacle, so that
they merge to the map as well.

Examples:
  mapwright crop campus.txt -o east.txt --bbox 50,0,112,90
  mapwright crop campus.txt -o near.txt --circle 40,30,20
  mapwright crop campus.txt -o tile.txt --bbox 0,0,30,30 --cut
  mapwright crop campus.txt --circle 40,30,20 -o - | mapwright info -
)";

class CropVerb : public Verb {
 public:
  std::string_view synopsis() const override {
    return "MAP -o PART.txt (--bbox X1,Y1,X2,Y2 | --circle X,Y,R)";
  }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    declare_map_argument(options, positionals, map_path_);
    auto add = options.add_options();
    add("output,o", po::value(&output_)->required(),
        "the part to write, its sidecar beside it; - writes the part alone to standard output");
    add("bbox", po::value(&bbox_), "X1,Y1,X2,Y2 in metres of the map");
    add("circle", po::value(&circle_), "X,Y,R in metres of the map: centre and radius");
    add("cut", po::bool_switch(&options_.cut), "clip outlines and walls at the box");
  }

  void configure(const po::variables_map&) override {
    if (bbox_.empty() == circle_.empty()) fail_usage("give either --bbox or --circle");
    if (!circle_.empty()) {
      const auto n = parse_numbers("circle", circle_, 3, 3);
      if (!(n[2] > 0.0)) fail_usage("--circle: the radius must be greater than 0");
      if (options_.cut) fail_usage("--cut goes with --bbox only: a disc's edge is no segment");
      region_ = CropRegion::of_disc({n[0], n[1]}, n[2]);
      return;
    }
    const auto n = parse_numbers("bbox", bbox_, 4, 4);
    region_.box = {n[0], n[1], n[2], n[3]};
    if (!(n[0] < n[2] && n[1] < n[3]))
      fail_usage("--bbox: X1 must be less than X2, and Y1 than Y2");
  }

  ExitStatus run(Console& console) override {
    const Map map = read_sound_map_file(map_path_).map;
    const auto sidecar = value_or_throw(read_sidecar(map_path_));
    ConvertedFiles files(output_, "");
    options_.resolution_m = resolution_of(map);
    auto part = value_or_throw(crop(map, region_, options_));
    const std::size_t count = part.map.obstacles.size();
    files.write_map(std::move(part.map), options_.resolution_m, console);
    files.write_sidecar(sidecar ? std::optional(moved(*sidecar, map_path_, output_)) : sidecar);
    files.commit_map();
    console.note(output_ + ": " + std::to_string(count) + " obstacles, " +
                 std::to_string(part.dropped) + " left out" +
                 (options_.cut ? ", " + std::to_string(part.cut) + " cut" : ""));
    if (part.protruding > 0) {
      console.note(std::to_string(part.protruding) +
                   " of them reach beyond the part's border (G109)" +
                   (options_.cut ? ": stairs and ramps are not cut" : "; --cut clips them"));
    }
    return ExitStatus::kSuccess;
  }

 private:
  std::string map_path_, output_, bbox_, circle_;
  CropRegion region_;
  CropOptions options_;
};

}  // namespace

std::unique_ptr<Verb> make_crop() {
  return std::make_unique<CropVerb>();
}

}  // namespace mapwright::cli
