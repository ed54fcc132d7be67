#include "cli/info/map_summary.hpp"
#include "cli/info/summary_output.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Tells what a map holds: obstacles and segments by shape type, indoor and outdoor, border and
extent, heights, minimum bounding circles, how compact the file is (bytes and bits per square metre
of the border's area, beside the report's 3 bytes/m2), and its georeference where a sidecar
MAP.georef.json stands beside the map.

What is wrong with the text is said on standard error, with line and column; the answer is about
what could be read. `mapwright validate` looks further.

Examples:
  mapwright info campus.txt
  mapwright info campus.txt --format json
  mapwright crop campus.txt --circle 40,30,20 -o - | mapwright info -
)";

class Info : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP [--format text|json]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    declare_map_argument(options, positionals, map_path_);
    declare_answer_format(options);
  }

  void configure(const po::variables_map& values) override { json_ = json_wanted(values); }

  ExitStatus run(Console& console) override {
    const MapDocument document = read_map_file(map_path_);
    report_findings(console, map_path_, document.findings);
    const auto georeference = read_sidecar_of(map_path_, console);
    const auto write = json_ ? write_summary_json : write_summary_text;
    write(console.out(), map_path_, summarize(document), georeference);
    const bool is_well = !has_errors(document.findings) && sidecar_is_well_;
    return is_well ? ExitStatus::kSuccess : ExitStatus::kNegative;
  }

 private:
  // A sidecar that makes no sense is a finding, not the end: the map itself can be read.
  std::optional<Georeference> read_sidecar_of(const std::string& map_path, Console& console) {
    auto sidecar = read_sidecar(map_path);
    if (sidecar) return *std::move(sidecar);
    sidecar_is_well_ = false;
    report_findings(console, sidecar_path(map_path),
                    {make_finding(FindingCode::C101, sidecar.error().message)});
    return std::nullopt;
  }

  std::string map_path_;
  bool json_ = false;
  bool sidecar_is_well_ = true;
};

}  // namespace

std::unique_ptr<Verb> make_info() {
  return std::make_unique<Info>();
}

}  // namespace mapwright::cli
