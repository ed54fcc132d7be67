#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "cli/fix/fix_answer.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/map_rules.hpp"
#include "cli/support/number_options.hpp"
#include "cli/support/policy_options.hpp"
#include "cli/support/unified_diff.hpp"
#include "cli/verb.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/text/reader.hpp"
#include "validators/fix/fix_map.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(Repairs what can be repaired safely: slips of the text, numbers of segments, the layout, ends that
nearly meet, segments that are there twice, outlines that run the wrong way, the order of stairs,
the border. `mapwright validate --list` marks the findings it knows to repair; where a repair is
not safe, nothing is done.

The text is edited where something is to be repaired: unknown tokens, semantic strings, text that
belongs to no record and the order of obstacles stay. No end of a segment moves farther than --snap.
After the repairs the map is validated again: a repair that brings a new finding is undone and told.
Repairing a repaired map changes nothing.

Results: what was done, how far anything moved, which errors remain; with --dry-run the change as a
unified diff, and nothing is written. Where the repaired map goes to standard output, they go to
standard error. Exit status 1 if errors remain.

Examples:
  mapwright fix campus.txt -o repaired.txt
  mapwright fix campus.txt --dry-run
  mapwright fix campus.txt --in-place --except layout
  mapwright fix campus.txt -o repaired.txt --only G105,G106 --snap 0.05
)";

constexpr std::string_view kLayout = "layout";

std::vector<std::string> words_of(const std::vector<std::string>& lists) {
  std::vector<std::string> words;
  for (const auto& list : lists) {
    for (std::size_t at = 0; at <= list.size();) {
      const auto comma = std::min(list.find(',', at), list.size());
      words.push_back(list.substr(at, comma - at));
      at = comma + 1;
    }
  }
  return words;
}

/// What --only and --except name.
struct Selection {
  std::set<FindingCode> codes;
  bool layout = false;
};

Selection selection(const char* option, const std::vector<std::string>& lists) {
  Selection selected;
  const auto& fixable = validators::fixable_codes();
  for (const auto& word : words_of(lists)) {
    if (word == kLayout) {
      selected.layout = true;
      continue;
    }
    const auto code = finding_code(word);
    if (!code || std::find(fixable.begin(), fixable.end(), *code) == fixable.end()) {
      fail_usage("--" + std::string(option) + ": '" + word +
                 "' is neither layout nor a finding that can be repaired; 'mapwright validate "
                 "--list' marks those");
    }
    selected.codes.insert(*code);
  }
  return selected;
}

class Fix : public Verb {
 public:
  std::string_view synopsis() const override {
    return "MAP (-o OUT | --in-place | --dry-run) [OPTIONS]";
  }
  std::string_view description() const override { return kDescription; }
  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void configure_target();
  void configure_selection();
  void write_answer(const std::string& before, const validators::FixOutcome& outcome,
                    const std::vector<Finding>& remaining, Console& console) const;
  void mention_sidecar(Console& console) const;

  std::string map_path_, output_;
  bool in_place_ = false, dry_run_ = false, json_ = false;
  std::vector<std::string> only_, except_;
  validators::FixOptions options_;
  PolicyOptions policy_options_;
};

void Fix::declare(po::options_description& options,
                  po::positional_options_description& positionals) {
  declare_map_argument(options, positionals, map_path_);
  auto add = options.add_options();
  add("output,o", po::value(&output_), "where to write the repaired map; - is standard output");
  add("in-place", po::bool_switch(&in_place_), "write it over the map");
  add("dry-run", po::bool_switch(&dry_run_), "write nothing; print the change as a unified diff");
  add("snap", text_value("0.01"),
      "metres: ends nearer to each other were meant to be one point; 0 moves nothing");
  add("only", po::value(&only_)->composing(), "repair these alone: codes with commas, and layout");
  add("except", po::value(&except_)->composing(), "do not repair these");
  declare_answer_format(options);
  declare_config_options(options);
}

void Fix::configure(const po::variables_map& values) {
  json_ = json_wanted(values);
  options_.snap_m = number_option(values, "snap", 0.0, 10.0);
  policy_options_ = policy_options(values);
  configure_target();
  configure_selection();
}

void Fix::configure_target() {
  const int targets = (output_.empty() ? 0 : 1) + (in_place_ ? 1 : 0) + (dry_run_ ? 1 : 0);
  if (targets != 1) fail_usage("say where the repaired map goes: one of -o, --in-place, --dry-run");
  if (in_place_ && map_path_ == "-")
    fail_usage("--in-place: standard input cannot be written over");
  if (in_place_) output_ = map_path_;
  if (json_ && output_ == "-") fail_usage("standard output cannot hold both the map and JSON");
}

void Fix::configure_selection() {
  if (!only_.empty()) {
    const Selection only = selection("only", only_);
    options_.codes = only.codes;
    options_.layout = only.layout;
  }
  const Selection except = selection("except", except_);
  for (const auto code : except.codes) options_.codes.erase(code);
  if (except.layout) options_.layout = false;
}

void Fix::mention_sidecar(Console& console) const {
  if (dry_run_ || in_place_ || map_path_ == "-" || output_ == "-") return;
  const std::string sidecar = sidecar_path(map_path_);
  std::error_code error;
  if (std::filesystem::exists(sidecar, error) && !std::filesystem::exists(sidecar_path(output_))) {
    console.note("the georeference stays in " + sidecar + "; copy it to " + sidecar_path(output_));
  }
}

void Fix::write_answer(const std::string& before, const validators::FixOutcome& outcome,
                       const std::vector<Finding>& remaining, Console& console) const {
  const std::string path(display_path(map_path_));
  const std::string target = dry_run_ ? path : std::string(display_path(output_));
  const std::string diff = dry_run_ ? unified_diff(before, outcome.text, path, path) : "";
  const FixAnswer answer{path, target, outcome, remaining, diff};
  if (json_) return write_fix_json(console.out(), answer);
  if (!dry_run_ && output_ != "-") return write_fix_text(console.out(), answer);
  console.out() << diff;
  std::ostringstream lines;
  write_fix_text(lines, answer);
  const std::string told = lines.str();
  if (!told.empty()) console.note(told.substr(0, told.size() - 1));
}

ExitStatus Fix::run(Console& console) {
  const MapRules rules(policy_options_, {map_path_});
  options_.validation = rules.profile(map_path_).validation;
  const std::string text = read_file(map_path_);
  const auto outcome = validators::fix_map(text, options_);
  const auto remaining = rules.judge(map_path_, read_map(outcome.text), outcome.after).findings;
  if (output_ == "-") {
    console.out() << outcome.text;
  } else if (!output_.empty()) {
    write_file(output_, [&](std::ostream& out) { out << outcome.text; });
  }
  write_answer(text, outcome, remaining, console);
  mention_sidecar(console);
  console.note(std::to_string(outcome.before.size()) + " findings before, " +
               std::to_string(outcome.after.size()) + " after");
  return has_errors(remaining) ? ExitStatus::kNegative : ExitStatus::kSuccess;
}

}  // namespace

std::unique_ptr<Verb> make_fix() {
  return std::make_unique<Fix>();
}

}  // namespace mapwright::cli
