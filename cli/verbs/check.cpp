#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "cli/check/batch.hpp"
#include "cli/check/checked_map.hpp"
#include "cli/check/gate_arguments.hpp"
#include "cli/check/record_sink.hpp"
#include "cli/check/run_settings.hpp"
#include "cli/check/shard_part.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/map_list.hpp"
#include "cli/support/map_reports.hpp"
#include "cli/support/map_rules.hpp"
#include "cli/support/number_options.hpp"
#include "cli/support/policy_options.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(The gate before a map goes to a robot. Each map is validated as the verb validate does, then a
simulated robot is sent out on it: what it can reach (proved, for its radius), whether paths between
random places are found, whether it finds its own place from laser scans. The verdict is fail if
there is a finding of severity error; warnings are reasons to look.

A folder stands for the maps (*.txt) in it. Each map is checked in a process of its own: one that
cannot be read, takes too long or too much memory, or makes the program crash costs only itself.
Maps are reported by path, each once.

Examples:
  mapwright check campus.txt
  mapwright check campus.txt --robot-radius 0.45 --trials 50 --format json -o verdict.json
  mapwright check maps/ --recursive --jobs 8 --time-limit 60
  mapwright check maps/ --jobs 8 --journal maps.journal --resume -o report.txt
                          (after a kill, the same command checks what is left)
  mapwright check maps/ --shard 2/4 --format json -o part-2.json
                          (the second of four machines; 'mapwright report merge' joins the parts)

Exit status 1 if a map fails or exceeds a limit, 3 if one cannot be read, 5 if one crashes the
program; the report is complete all the same.
)";

class Check : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP|FOLDER... [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }
  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void declare_batch(po::options_description& options);
  void read_rules();
  validators::MapRecord check(const MapInput& map, unsigned threads) const;
  void write_report(std::ostream& out, bool colour, Console& console);
  std::unique_ptr<RecordSink> make_sink(std::ostream& out, bool colour) const;

  std::vector<std::string> paths_;
  std::string format_name_, output_, journal_path_;
  bool recursive_ = false;
  bool resume_ = false;
  std::optional<Shard> shard_;
  const validators::ReportFormat* format_ = nullptr;
  RunSettings settings_;
  std::vector<MapInput> all_maps_;  // of all shards
  Batch batch_;
  std::optional<std::string> standard_input_;
  validators::GateOptions options_;
  std::set<std::string> given_;
  PolicyOptions policy_options_;
  std::optional<MapRules> rules_;
  std::unique_ptr<Journal> journal_;
  ReportTotals totals_;
};

void Check::declare(po::options_description& options,
                    po::positional_options_description& positionals) {
  options.add_options()("map", po::value(&paths_)->required()->composing(),
                        "maps, or folders of maps; - reads standard input");
  declare_gate_options(options);
  declare_policy_options(options);
  declare_batch(options);
  auto add = options.add_options();
  add("format", po::value(&format_name_)->default_value("text"),
      ("how to write the report: " + report_format_names()).c_str());
  add("output,o", po::value(&output_)->default_value("-"),
      "where to write it; - is standard output");
  positionals.add("map", -1);
}

void Check::declare_batch(po::options_description& options) {
  auto add = options.add_options();
  add("recursive,r", po::bool_switch(&recursive_), "look for maps in subfolders of folders too");
  add("jobs", text_value("1"),
      "maps to check at once; 0: as many as the machine has cores. The report is the same");
  add("time-limit", text_value("600"), "seconds that the check of one map may take; 0: no limit");
  add("memory-limit", text_value("0"),
      "megabytes of memory (address space) that the check of one map may take; 0: no limit");
  add("shard", po::value<std::string>(),
      "part/parts: check this part of the maps only. Which part a map is in depends on its path "
      "alone; with --format json the report can be merged");
  add("journal", po::value(&journal_path_),
      "keep each map's outcome in this file as soon as known");
  add("resume", po::bool_switch(&resume_),
      "go on with the journal: maps in it that have not changed are not checked again");
}

void Check::configure(const po::variables_map& values) {
  format_ = &find_report_format(format_name_);
  check_report_output(*format_, output_);
  if (values.count("shard") > 0) {
    shard_ = parse_shard("shard", values["shard"].as<std::string>());
  }
  batch_.jobs = static_cast<unsigned>(integer_option(values, "jobs", 0, 1024));
  batch_.limits.time_s = number_option(values, "time-limit", 0.0, 1e9);
  batch_.limits.memory_bytes =
      static_cast<std::uint64_t>(1e6 * number_option(values, "memory-limit", 0.0, 1e9));
  options_ = gate_options(values);
  given_ = given_options(values);
  policy_options_ = policy_options(values);
  if (shard_ && shard_->parts > 1 && !policy_options_.write_baseline.empty()) {
    fail_usage("a baseline holds all maps: --write-baseline and --shard exclude each other");
  }
  if (std::count(paths_.begin(), paths_.end(), "-") > 1) {
    fail_usage("standard input can be read once only");
  }
  if (resume_ && journal_path_.empty())
    fail_usage("--resume: say with --journal what to go on with");
  if (journal_path_ == "-") fail_usage("--journal: name a file that a later run can go on with");
  settings_ = run_settings(values);
}

ExitStatus Check::run(Console& console) {
  const auto subfolders = recursive_ ? Subfolders::kEnter : Subfolders::kSkip;
  all_maps_ = expand_map_paths(paths_, subfolders);
  batch_.maps = shard_ ? shard_of(all_maps_, *shard_) : all_maps_;
  const auto is_piped = [](const MapInput& map) { return map.path == "-"; };
  if (std::any_of(batch_.maps.begin(), batch_.maps.end(), is_piped)) {
    standard_input_ = read_file("-");
  }
  read_rules();
  if (!journal_path_.empty()) {
    const auto start = resume_ ? JournalStart::kResume : JournalStart::kNew;
    journal_ = std::make_unique<Journal>(journal_path_, settings_.fingerprint(), start);
  }
  if (output_ == "-") {
    write_report(console.out(), is_colour_terminal(console), console);
  } else {
    write_file(output_, [&](std::ostream& out) { write_report(out, false, console); });
  }
  console.note(totals_.summary());
  return rules_->status(totals_);
}

// Those of all shards, so that all have the same settings.
void Check::read_rules() {
  std::vector<std::string> paths;
  for (const auto& map : all_maps_) paths.push_back(map.path);
  rules_.emplace(policy_options_, paths);
  settings_.options["config"] = policies_digest(rules_->policies(), policy_options_.today);
}

validators::MapRecord Check::check(const MapInput& map, unsigned threads) const {
  auto options = with_profile(options_, rules_->profile(map.path), given_);
  options.deployment.threads = threads;
  return check_map(map.path, map.path == "-" ? standard_input_ : std::nullopt, options, *rules_);
}

void Check::write_report(std::ostream& out, bool colour, Console& console) {
  const auto sink = make_sink(out, colour);
  batch_.check = [this](const MapInput& map, unsigned threads) { return check(map, threads); };
  check_batch(batch_, journal_.get(), console, [&](const validators::MapRecord& record) {
    if (record.unreadable) console.error(*record.unreadable);
    totals_.add(record.report({}));
    rules_->add(record.report({}));
    sink->add(record);
  });
  // Other shards may need the suppressions that this one does not.
  for (const auto& report : rules_->policy_reports(!shard_ || shard_->parts == 1)) {
    totals_.add_findings(report.findings);
    sink->add_configuration(report);
  }
  rules_->write_baseline();
  sink->finish();
}

std::unique_ptr<RecordSink> Check::make_sink(std::ostream& out, bool colour) const {
  if (shard_ && format_->name == "json") {
    return make_part_sink(
        shard_header(*shard_, settings_, all_maps_, rules_->policies(), policy_options_.today),
        out);
  }
  return make_report_sink(*format_, out, colour, standard_input_);
}

}  // namespace

std::unique_ptr<Verb> make_check() {
  return std::make_unique<Check>();
}

}  // namespace mapwright::cli
