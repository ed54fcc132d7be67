#include <algorithm>

#include "cli/convert/converted_files.hpp"
#include "cli/support/error.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"
#include "mapcore/parts/merge.hpp"
#include "mapcore/text/map_resolution.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Puts maps together. An obstacle that several parts have is taken once, so that the parts of a map
that 'mapwright crop' made, with --cut or without, give the map again, to the byte, where its ids ascend
as convert's do. The border is the box around all borders. Pieces of cut obstacles that were changed
since are refused.

Obstacles of different places with the same id are told apart: the later one gets a new id, which is
said. Different versions of one obstacle (same id, a segment in common) stop the merge, unless
--prefer says which counts. Maps must have the same frame: merge maps of different ones through GIS,
'mapwright export B.txt -o b.gpkg' and 'mapwright convert a.gpkg b.gpkg', which takes all into the
frame of the first.

What is wrong with the result, obstacles that overlap above all, is told as by 'validate'.

Exit status: 0 the map is written and valid; 1 it is written but validation finds errors; 2 the parts
cannot be put together; 3 a part cannot be read.

Examples:
  mapwright merge west.txt east.txt -o campus.txt
  mapwright merge campus.txt robot_part.txt -o campus.txt --prefer last
)";

bool same_frame(const Georeference& p, const Georeference& q) {
  return p.origin_latitude_deg == q.origin_latitude_deg &&
         p.origin_longitude_deg == q.origin_longitude_deg &&
         p.origin_height_m == q.origin_height_m && p.heading_deg == q.heading_deg &&
         p.projection == q.projection;
}

class MergeVerb : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP... -o OUT.txt [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    auto add = options.add_options();
    add("map", po::value(&map_paths_)->required(), "the maps to put together");
    add("output,o", po::value(&output_)->required(),
        "the map to write, its sidecar beside it; - writes the map alone to standard output");
    add("prefer", po::value(&prefer_),
        "which version of an obstacle counts where parts differ: first or last");
    add("same-frame", po::bool_switch(&same_frame_),
        "take maps without a sidecar to be in the frame of those that have one");
    positionals.add("map", -1);
  }

  void configure(const po::variables_map&) override {
    if (prefer_.empty()) return;
    if (prefer_ != "first" && prefer_ != "last") {
      fail_usage("--prefer: '" + prefer_ + "' is neither first nor last");
    }
    preference_ = prefer_ == "first" ? MergePreference::kFirst : MergePreference::kLast;
  }

  ExitStatus run(Console& console) override {
    std::vector<MergePart> parts;
    double resolution_m = 1.0;
    for (const auto& path : map_paths_) {
      parts.push_back({path, read_sound_map_file(path).map});
      resolution_m = std::min(resolution_m, resolution_of(parts.back().map));
    }
    const auto sidecar = common_sidecar();
    ConvertedFiles files(output_, "");
    auto merged = value_or_throw(merge(std::move(parts), preference_));
    for (const auto& note : merged.notes) console.warning(note);
    const std::size_t count = merged.map.obstacles.size();
    const auto findings = files.write_map(std::move(merged.map), resolution_m, console);
    files.write_sidecar(sidecar);
    files.commit_map();
    report_findings(console, output_, findings);
    console.note(output_ + ": " + std::to_string(count) + " obstacles of " +
                 std::to_string(map_paths_.size()) + " maps");
    return has_errors(findings) ? ExitStatus::kNegative : ExitStatus::kSuccess;
  }

 private:
  // The first sidecar, with the sources of all.
  std::optional<Georeference> common_sidecar() const {
    std::optional<Georeference> common;
    std::string common_path, bare_path;
    for (const auto& path : map_paths_) {
      const auto sidecar = value_or_throw(read_sidecar(path));
      if (!sidecar) {
        bare_path = path;
        continue;
      }
      const Georeference own = moved(*sidecar, path, output_);
      if (!common) {
        common = own;
        common_path = path;
      } else if (!same_frame(*common, own)) {
        fail_usage(path + " has another frame than " + common_path +
                   ": merge them through GIS (export both, convert the layers together)");
      } else {
        add_sources(own, *common);
      }
    }
    if (common && !bare_path.empty() && !same_frame_) {
      fail_usage(bare_path + " has no sidecar and " + common_path +
                 " has one: --same-frame takes them to have the same frame");
    }
    return common;
  }

  static void add_sources(const Georeference& from, Georeference& to) {
    for (const auto& source : from.sources) {
      const auto same = std::find(to.sources.begin(), to.sources.end(), source);
      if (same == to.sources.end()) to.sources.push_back(source);
    }
  }

  std::vector<std::string> map_paths_;
  std::string output_, prefer_;
  MergePreference preference_ = MergePreference::kNone;
  bool same_frame_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_merge() {
  return std::make_unique<MergeVerb>();
}

}  // namespace mapwright::cli
