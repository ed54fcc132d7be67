#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "cli/check/gate_arguments.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/map_list.hpp"
#include "cli/support/map_reports.hpp"
#include "cli/support/map_rules.hpp"
#include "cli/support/policy_options.hpp"
#include "cli/verb.hpp"
#include "navcore/parallel.hpp"
#include "validators/deployment/deployment_gate.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;
using validators::MapReport;

constexpr std::string_view kDescription =
    R"(The gate before a map goes to a robot. Each map is validated as the verb validate does, then a
simulated robot is sent out on it: what it can reach (proved, for its radius), whether paths between
random places are found, whether it finds its own place from laser scans. The verdict is fail if
there is a finding of severity error; warnings are reasons to look.

A folder stands for the maps (*.txt) in it. A map that cannot be read costs only itself.

Examples:
  mapwright check campus.txt
  mapwright check campus.txt --robot-radius 0.45 --trials 50 --format json -o verdict.json
  mapwright check maps/ --jobs 8
  mapwright check maps/ --shard 2/4        (the second of four machines)
  mapwright check maps/ --config site.yaml --baseline known.json

Exit status 1 if a map fails, 3 if one cannot be read.
)";

/// A map's report with the text it quotes.
struct CheckedMap {
  std::string path;
  std::string text;
  std::vector<Finding> findings;
  std::vector<validators::ReportSection> sections;
  std::optional<std::string> unreadable;
  std::vector<validators::Fingerprint> names = {};
  std::vector<validators::SuppressedFinding> suppressed = {};
};

CheckedMap check_map(const std::string& path, const validators::GateOptions& options,
                     const MapRules& rules) {
  CheckedMap checked{std::string(display_path(path)), {}, {}, {}, {}};
  try {
    const MapDocument document = read_map_file(path);
    validators::GateOutcome outcome = check_deployment(document, options);
    if (auto finding = sidecar_finding(path)) outcome.findings.push_back(*std::move(finding));
    checked.sections = deployment_sections(outcome, options);
    auto judgement = rules.judge(path, document, std::move(outcome.findings));
    checked.findings = std::move(judgement.findings);
    checked.names = std::move(judgement.names);
    checked.suppressed = std::move(judgement.suppressed);
    checked.text = document.text;
  } catch (const Error& error) {
    checked.unreadable = error.what();
  } catch (const std::exception& error) {
    checked.unreadable = checked.path + ": cannot be checked: " + error.what();
  }
  return checked;
}

/// Hands maps on in their order, whatever order they are finished in.
class InOrder {
 public:
  InOrder(validators::ReportWriter& writer, ReportTotals& totals, MapRules& rules, Console& console)
      : writer_(writer), totals_(totals), rules_(rules), console_(console) {}

  void add(std::size_t number, CheckedMap checked) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(number, std::move(checked));
    while (!waiting_.empty() && waiting_.begin()->first == next_) {
      write(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
      ++next_;
    }
  }

 private:
  void write(const CheckedMap& checked) {
    if (checked.unreadable) console_.error(*checked.unreadable);
    const MapReport report{checked.path,     checked.text, checked.findings, checked.unreadable,
                           checked.sections, {},           checked.names,    checked.suppressed};
    writer_.map(report);
    totals_.add(report);
    rules_.add(report);
  }

  std::mutex mutex_;
  std::map<std::size_t, CheckedMap> waiting_;
  std::size_t next_ = 0;
  validators::ReportWriter& writer_;
  ReportTotals& totals_;
  MapRules& rules_;
  Console& console_;
};

class Check : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP|FOLDER... [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }
  void declare(po::options_description& options,
               po::positional_options_description& positionals) override;
  void configure(const po::variables_map& values) override;
  ExitStatus run(Console& console) override;

 private:
  void check_all(const std::vector<std::string>& maps, std::ostream& out, bool colour,
                 Console& console);

  std::vector<std::string> paths_;
  std::string format_name_;
  std::string output_;
  const validators::ReportFormat* format_ = nullptr;
  validators::GateOptions options_;
  Shard shard_;
  unsigned jobs_ = 1;
  std::set<std::string> given_;
  PolicyOptions policy_options_;
  std::optional<MapRules> rules_;
  ReportTotals totals_;
};

void Check::declare(po::options_description& options,
                    po::positional_options_description& positionals) {
  const auto text = [](const char* value) {
    return po::value<std::string>()->default_value(value);
  };
  auto add = options.add_options();
  add("map", po::value(&paths_)->required()->composing(),
      "maps, or folders of maps; - reads standard input");
  declare_gate_options(options);
  declare_policy_options(options);
  add("jobs", text("1"), "threads; 0: as many as the machine has. The answer is the same");
  add("shard", text("1/1"), "part/parts: check this part of the maps only");
  add("format", po::value(&format_name_)->default_value("text"),
      ("how to write the report: " + report_format_names()).c_str());
  add("output,o", po::value(&output_)->default_value("-"),
      "where to write it; - is standard output");
  positionals.add("map", -1);
}

void Check::configure(const po::variables_map& values) {
  const auto text = [&](const char* name) { return values[name].as<std::string>(); };
  format_ = &find_report_format(format_name_);
  check_report_output(*format_, output_);
  shard_ = parse_shard("shard", text("shard"));
  jobs_ = static_cast<unsigned>(parse_integer("jobs", text("jobs"), 0, 1024));
  if (std::count(paths_.begin(), paths_.end(), "-") > 1) {
    fail_usage("standard input can be read once only");
  }
  options_ = gate_options(values);
  given_ = given_options(values);
  policy_options_ = policy_options(values);
  if (shard_.parts > 1 && !policy_options_.write_baseline.empty()) {
    fail_usage("a baseline holds all maps: --write-baseline and --shard exclude each other");
  }
}

void Check::check_all(const std::vector<std::string>& maps, std::ostream& out, bool colour,
                      Console& console) {
  // One map alone gets all threads for its localization runs.
  options_.deployment.threads = maps.size() == 1 ? jobs_ : 1;
  const auto writer = format_->make(out, {"check", colour});
  InOrder in_order(*writer, totals_, *rules_, console);
  const auto progress = console.progress("checking");
  std::mutex mutex;
  std::size_t done = 0;
  navcore::parallel_for(maps.size(), 1, jobs_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto options = with_profile(options_, rules_->profile(maps[i]), given_);
      in_order.add(i, check_map(maps[i], options, *rules_));
      const std::lock_guard lock(mutex);
      if (maps.size() > 1) progress(++done, maps.size());
    }
  });
  // Other shards may need the suppressions that this one does not.
  rules_->finish(*writer, totals_, shard_.parts == 1);
  writer->finish();
}

ExitStatus Check::run(Console& console) {
  const auto maps = shard_of(expand_map_paths(paths_), shard_);
  rules_.emplace(policy_options_, maps);
  if (output_ == "-") {
    check_all(maps, console.out(), is_colour_terminal(console), console);
  } else {
    write_file(output_, [&](std::ostream& out) { check_all(maps, out, false, console); });
  }
  console.note(totals_.summary());
  return rules_->status(totals_);
}

}  // namespace

std::unique_ptr<Verb> make_check() {
  return std::make_unique<Check>();
}

}  // namespace mapwright::cli
