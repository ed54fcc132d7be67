#include <memory>

#include "cli/check/record_sink.hpp"
#include "cli/check/shard_part.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/map_reports.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

constexpr std::string_view kDescription =
    R"(report merge joins the parts that 'mapwright check --shard i/n --format json' wrote, one from each
machine, to the report that one machine would have written: the same bytes for any number of parts.
It refuses parts that are missing or there twice, and parts of different runs: other options, seeds,
limits or maps, another version of mapwright.

Formats that draw maps read the maps again and need them to be as they were checked.

Examples:
  mapwright report merge part-*.json
  mapwright report merge part-1.json part-2.json part-3.json --format json -o report.json

The exit status is that of the check of all maps: 1 if one fails or exceeds a limit, 3 if one could
not be read, 5 if one crashed the program. 2: these parts make no whole.
)";

class Report : public Verb {
 public:
  std::string_view synopsis() const override { return "merge PART... [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    auto add = options.add_options();
    add("job", po::value(&job_)->required(), "what to do: merge");
    add("part", po::value(&parts_)->composing(), "files that check --shard wrote");
    add("format", po::value(&format_name_)->default_value("text"),
        ("how to write the report: " + report_format_names()).c_str());
    add("output,o", po::value(&output_)->default_value("-"),
        "where to write it; - is standard output");
    positionals.add("job", 1).add("part", -1);
  }

  void configure(const po::variables_map&) override {
    if (job_ != "merge") fail_usage("report: '" + job_ + "' is no job; the one there is: merge");
    if (parts_.empty()) fail_usage("report merge: name the parts");
    format_ = &find_report_format(format_name_);
    check_report_output(*format_, output_);
  }

  ExitStatus run(Console& console) override {
    std::vector<ShardPart> parts;
    for (const auto& path : parts_) parts.push_back(read_part(path));
    const auto records = merged(parts);
    const auto configurations = configuration_reports(parts.front(), records);
    const auto write = [&](std::ostream& out, bool colour) {
      write_report(records, configurations, out, colour);
    };
    if (output_ == "-") {
      write(console.out(), is_colour_terminal(console));
    } else {
      write_file(output_, [&](std::ostream& out) { write(out, false); });
    }
    console.note(totals_.summary());
    return totals_.status();
  }

 private:
  void write_report(const std::vector<validators::MapRecord>& records,
                    const std::vector<validators::MapReport>& configurations, std::ostream& out,
                    bool colour) {
    const auto sink = make_report_sink(*format_, out, colour);
    for (const auto& record : records) {
      totals_.add(record.report({}));
      sink->add(record);
    }
    for (const auto& report : configurations) {
      totals_.add_findings(report.findings);
      sink->add_configuration(report);
    }
    sink->finish();
  }

  std::string job_, format_name_, output_;
  std::vector<std::string> parts_;
  const validators::ReportFormat* format_ = nullptr;
  ReportTotals totals_;
};

}  // namespace

std::unique_ptr<Verb> make_report() {
  return std::make_unique<Report>();
}

}  // namespace mapwright::cli
