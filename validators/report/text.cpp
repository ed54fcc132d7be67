#include "validators/report/text.hpp"

#include <ostream>

#include "validators/report/report.hpp"
#include "validators/report/source_lines.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Escape sequences of ECMA-48 (SGR).
constexpr std::string_view kBold = "\033[1m";
constexpr std::string_view kReset = "\033[0m";
constexpr std::string_view kGreen = "\033[32m";

std::string_view colour_of(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "\033[1;31m";
    case Severity::kWarning:
      return "\033[1;35m";
    case Severity::kNote:
      return "\033[1;36m";
  }
  return kBold;
}

std::string painted(std::string_view text, std::string_view colour, bool on) {
  if (!on) return std::string(text);
  return std::string(colour) + std::string(text) + std::string(kReset);
}

std::string place_of(std::string_view path, const Finding& finding) {
  std::string place(path);
  if (finding.place) {
    place +=
        ':' + std::to_string(finding.place->line) + ':' + std::to_string(finding.place->column);
  }
  return place + ":";
}

class TextReport : public ReportWriter {
 public:
  TextReport(std::ostream& out, const ReportOptions& options)
      : out_(out), colour_(options.colour) {}

  void map(const MapReport& report) override {
    if (report.unreadable) {
      out_ << report.path << ": " << painted("error", colour_of(Severity::kError), colour_) << ": "
           << *report.unreadable << '\n';
      return;
    }
    SourceLines lines(report.text);
    for (const auto& finding : report.findings) {
      out_ << finding_line(report.path, finding, colour_) << '\n';
      if (finding.place) {
        const auto line = lines.line(finding.place->line);
        out_ << painted(excerpt(line, finding.place->column), kGreen, colour_);
      }
    }
    for (const auto& section : report.sections) {
      out_ << painted(std::string(report.path) + ":", kBold, colour_) << ' ' << section.line
           << '\n';
    }
  }

  void finish() override {}

 private:
  std::ostream& out_;
  bool colour_;
};

}  // namespace

std::string finding_line(std::string_view path, const Finding& finding, bool colour) {
  return painted(place_of(path, finding), kBold, colour) + " " +
         painted(to_string(finding.severity), colour_of(finding.severity), colour) + ": " +
         message_text(finding) + " [" + std::string(finding_type(finding.code).id) + "]";
}

std::unique_ptr<ReportWriter> make_text_report(std::ostream& out, const ReportOptions& options) {
  return std::make_unique<TextReport>(out, options);
}

}  // namespace mapwright::validators
