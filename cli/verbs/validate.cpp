#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iterator>
#include <memory>
#include <optional>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/map_reports.hpp"
#include "cli/support/map_rules.hpp"
#include "cli/support/policy_options.hpp"
#include "cli/support/validated_map.hpp"
#include "cli/verb.hpp"
#include "converter/ledger/obstacle_sources.hpp"
#include "validators/check_pages.hpp"
#include "validators/fix/fix_map.hpp"
#include "validators/report/report.hpp"
#include "validators/validator.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;
using validators::MapReport;

constexpr std::string_view kDescription =
    R"(Reads maps and tells everything that is wrong with them: defects of the text, of shapes, of
attributes, of stairs and ramps. Each finding has a code, a severity, line and column, and a place
on the map. A map's georeference sidecar (MAP.georef.json), where there is one, is read too.

A configuration file sets severities and limits, and suppresses findings that somebody has looked
at, with a reason; a baseline lets only new findings count (docs/configuration.md).

The exit status is 1 if a finding of severity error was found, 3 if a map could not be read (the
others are still reported), else 0. Warnings do not change it.

Examples:
  mapwright validate campus.txt
  mapwright validate north.txt south.txt --format json -o findings.json
  mapwright convert site.gpkg -o - | mapwright validate -
  mapwright validate campus.txt --ledger ledger.json --format gpkg -o findings.gpkg
  mapwright validate maps/*.txt --profile strict --baseline known.json
  mapwright validate --explain G104
  mapwright validate --list
)";

void print_catalogue(std::ostream& out) {
  const auto& fixable = validators::fixable_codes();
  for (const auto& type : finding_catalogue()) {
    out << type.id << "  " << std::left << std::setw(8) << to_string(type.severity) << "  "
        << std::setw(26) << type.name << "  " << type.summary
        << (std::binary_search(fixable.begin(), fixable.end(), type.code) ? " [fix]" : "") << '\n';
  }
}

// Obstacles that name GIS features want one.
bool lacks_sidecar(const std::string& path) {
  std::error_code error;
  return path != "-" && !std::filesystem::exists(sidecar_path(path), error);
}

class Validate : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP... [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    auto add = options.add_options();
    add("map", po::value(&paths_)->composing(), "maps to validate; - reads standard input");
    add("format", po::value(&format_name_)->default_value("text"),
        ("how to write the findings: " + report_format_names()).c_str());
    add("output,o", po::value(&output_)->default_value("-"),
        "where to write them; - is standard output");
    add("ledger", po::value(&ledger_),
        "what convert --report wrote for the map: findings name GIS layer and feature");
    add("list", po::bool_switch(&list_),
        "list all findings there are: code, severity, name, what it means; [fix] marks those that "
        "the verb fix can repair");
    add("explain", po::value(&explain_),
        "print the page of a code: what it is, why it hurts a robot, how to fix it");
    declare_policy_options(options);
    positionals.add("map", -1);
  }

  void configure(const po::variables_map& values) override {
    if (!explain_.empty()) {
      explained_ = finding_code(explain_);
      if (!explained_) fail_usage("--explain: there is no finding '" + explain_ + "'; see --list");
    }
    format_ = &find_report_format(format_name_);
    check_report_output(*format_, output_);
    if (!ledger_.empty() && paths_.size() != 1)
      fail_usage("--ledger: it is about one map, name that");
    policy_options_ = policy_options(values);
    if (paths_.empty() && !list_ && !explained_) fail_usage("name a map to validate");
  }

  ExitStatus run(Console& console) override {
    if (list_) print_catalogue(console.out());
    if (explained_) console.out() << validators::check_page(*explained_);
    if (paths_.empty()) return ExitStatus::kSuccess;
    if (!ledger_.empty()) sources_ = read_ledger();
    rules_.emplace(policy_options_, paths_);
    if (output_ == "-") {
      write_report(console.out(), is_colour_terminal(console), console);
    } else {
      write_file(output_, [&](std::ostream& out) { write_report(out, false, console); });
    }
    console.note(totals_.summary());
    return rules_->status(totals_);
  }

 private:
  converter::ObstacleSources read_ledger() const {
    auto sources = converter::ObstacleSources::parse(read_file(ledger_));
    if (!sources) throw Error(ExitStatus::kInput, ledger_ + ": " + sources.error().message);
    return *std::move(sources);
  }

  void write_report(std::ostream& out, bool colour, Console& console) {
    const auto writer = format_->make(out, {"validate", colour});
    const auto progress = console.progress("validating");
    const bool is_only = paths_.size() == 1;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      report_map(paths_[i], i + 1 == paths_.size(), *writer, console,
                 is_only ? progress : Progress());
      if (!is_only) progress(i + 1, paths_.size());
    }
    for (const auto& report : rules_->policy_reports(true)) {
      totals_.add_findings(report.findings);
      writer->map(report);
    }
    rules_->write_baseline();
    writer->finish();
  }

  void report_map(const std::string& path, bool is_last, validators::ReportWriter& writer,
                  Console& console, const Progress& progress) {
    MapReport report{display_path(path), {}, {}, {}, {}};
    auto document = std::make_unique<MapDocument>();
    try {
      const auto options = validators::validation_options(rules_->profile(path));
      auto validated = validated_file(path, options, progress, lacks_sidecar(path));
      *document = std::move(validated.document);
      report.text = document->text;
      judge(path, *document, std::move(validated.findings), report);
    } catch (const Error& error) {
      if (error.status() != ExitStatus::kInput) throw;
      console.error(error.what());
      report.unreadable = error.what();
    }
    writer.map(report);
    totals_.add(report);
    rules_->add(report);
    if (is_last) keep_to_the_end(std::move(document));
  }

  void judge(const std::string& path, const MapDocument& document, std::vector<Finding> findings,
             MapReport& report) const {
    auto more = sidecar_findings(path, document.map);
    findings.insert(findings.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
    if (sources_) sources_->name_features(findings);
    auto judgement = rules_->judge(path, document, std::move(findings));
    report.findings = std::move(judgement.findings);
    report.names = std::move(judgement.names);
    report.suppressed = std::move(judgement.suppressed);
  }

  std::vector<std::string> paths_;
  std::string format_name_;
  std::string output_;
  std::string explain_;
  std::string ledger_;
  std::optional<converter::ObstacleSources> sources_;
  bool list_ = false;
  std::optional<FindingCode> explained_;
  const validators::ReportFormat* format_ = nullptr;
  PolicyOptions policy_options_;
  std::optional<MapRules> rules_;
  ReportTotals totals_;
};

}  // namespace

std::unique_ptr<Verb> make_validate() {
  return std::make_unique<Validate>();
}

}  // namespace mapwright::cli
