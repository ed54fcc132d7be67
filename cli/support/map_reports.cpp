#include "cli/support/map_reports.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

#include "cli/support/error.hpp"
#include "cli/support/findings_layers.hpp"
#include "cli/support/map_files.hpp"
#include "converter/frame/frame_agreement.hpp"
#include "mapcore/georeference.hpp"
#include "validators/georeference_checks.hpp"

namespace mapwright::cli {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace

std::string report_format_names() {
  std::string names;
  for (const auto* formats : {&validators::report_formats(), &gis_report_formats()}) {
    for (const auto& format : *formats) {
      names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
  }
  return names;
}

const validators::ReportFormat& find_report_format(const std::string& name) {
  if (const auto* format = validators::find_report_format(name)) return *format;
  for (const auto& format : gis_report_formats()) {
    if (format.name == name) return format;
  }
  fail_usage("--format: '" + name + "' is none of " + report_format_names());
}

void check_report_output(const validators::ReportFormat& format, const std::string& output) {
  if (format.is_binary && output == "-") {
    fail_usage("--format " + std::string(format.name) + " is no text: name a file with -o");
  }
}

bool is_colour_terminal(const Console& console) {
  const char* no_colour = std::getenv("NO_COLOR");  // https://no-color.org
  const char* terminal = std::getenv("TERM");
  return &console.out() == &std::cout && isatty(STDOUT_FILENO) == 1 &&
         (no_colour == nullptr || *no_colour == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

std::vector<Finding> sidecar_findings(const std::string& map_path, const Map& map) {
  if (map_path == "-") return {};
  const auto georeference = read_sidecar(map_path);
  if (!georeference) {
    return {make_finding(FindingCode::C101,
                         sidecar_path(map_path) + ": " + georeference.error().message)};
  }
  auto findings = validators::check_georeference(map, *georeference);
  if (!*georeference) return findings;
  if (auto mismatch = converter::frame_mismatch(**georeference)) {
    findings.push_back(*std::move(mismatch));
  }
  return findings;
}

void ReportTotals::add(const validators::MapReport& report) {
  ++maps_;
  if (report.unreadable) ++count_of(report.interruption);
  failed_ += !report.unreadable && !report.passes() ? 1 : 0;
  suppressed_ += report.suppressed.size();
  add_findings(report.findings);
}

void ReportTotals::add_findings(const std::vector<Finding>& findings) {
  for (const auto& finding : findings) {
    switch (finding.severity) {
      case Severity::kError:
        ++errors_;
        break;
      case Severity::kWarning:
        ++warnings_;
        break;
      case Severity::kNote:
        ++notes_;
        break;
    }
  }
}

std::size_t& ReportTotals::count_of(validators::Interruption interruption) {
  switch (interruption) {
    case validators::Interruption::kNone:
      return unreadable_;
    case validators::Interruption::kCrash:
      return crashed_;
    case validators::Interruption::kTimeLimit:
    case validators::Interruption::kMemoryLimit:
      return over_limit_;
  }
  return unreadable_;
}

std::string ReportTotals::summary() const {
  std::string text = counted(maps_, "map") + ": ";
  const std::size_t fit = maps_ - failed_ - unreadable_ - over_limit_ - crashed_;
  text += std::to_string(fit) + " fit, " + std::to_string(failed_) + " not";
  if (unreadable_ > 0) text += ", " + std::to_string(unreadable_) + " unreadable";
  if (over_limit_ > 0) text += ", " + std::to_string(over_limit_) + " over a limit";
  if (crashed_ > 0) text += ", " + std::to_string(crashed_) + " crashed";
  text += "; " + counted(errors_, "error") + ", " + counted(warnings_, "warning");
  if (notes_ > 0) text += ", " + counted(notes_, "note");
  if (suppressed_ > 0) text += "; " + std::to_string(suppressed_) + " suppressed";
  return text;
}

ExitStatus ReportTotals::status() const {
  if (crashed_ > 0) return ExitStatus::kInternal;
  if (unreadable_ > 0) return ExitStatus::kInput;
  return errors_ + over_limit_ > 0 ? ExitStatus::kNegative : ExitStatus::kSuccess;
}

}  // namespace mapwright::cli
