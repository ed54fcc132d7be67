#include "cli/check/record_sink.hpp"

#include <utility>

#include "cli/check/checked_map.hpp"
#include "cli/check/summary_table.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"

namespace mapwright::cli {
namespace {

using validators::MapRecord;

class ReportSink : public RecordSink {
 public:
  ReportSink(const validators::ReportFormat& format, std::ostream& out, bool colour,
             std::optional<std::string> standard_input)
      : out_(out),
        writer_(format.make(out, {"check", colour})),
        has_table_(format.name == "text"),
        standard_input_(std::move(standard_input)) {}

  void add(const MapRecord& record) override {
    const bool whole = writer_->needs_whole_text() && !record.digest.empty();
    const std::string text = whole ? whole_text(record) : record.quoted_text();
    const auto report = record.report(text);
    writer_->map(report);
    table_.add(report);
  }

  void add_configuration(const validators::MapReport& report) override { writer_->map(report); }

  void finish() override {
    writer_->finish();
    if (has_table_ && table_.maps() > 1) table_.write(out_);
  }

 private:
  std::string whole_text(const MapRecord& record) const {
    const bool piped = record.path == display_path("-");
    if (piped && standard_input_) return *standard_input_;
    std::string text = piped ? "" : read_file(record.path);
    if (!piped && map_digest(record.path, text) == record.digest) return text;
    throw Error(ExitStatus::kInput,
                record.path + (piped ? ": is gone" : ": has changed since it was checked") +
                    "; this format draws the maps, check again or choose --format json");
  }

  std::ostream& out_;
  std::unique_ptr<validators::ReportWriter> writer_;
  bool has_table_;
  std::optional<std::string> standard_input_;
  SummaryTable table_;
};

}  // namespace

std::unique_ptr<RecordSink> make_report_sink(const validators::ReportFormat& format,
                                             std::ostream& out, bool colour,
                                             std::optional<std::string> standard_input) {
  return std::make_unique<ReportSink>(format, out, colour, std::move(standard_input));
}

}  // namespace mapwright::cli
