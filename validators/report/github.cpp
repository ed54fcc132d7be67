#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "validators/report/report.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Workflow commands of GitHub Actions: a line "::error file=a.txt,line=3::message". Values of
// properties must not hold what separates them.
using Escapes = std::vector<std::pair<char, std::string_view>>;

const Escapes& message_escapes() {
  static const Escapes escapes{{'%', "%25"}, {'\r', "%0D"}, {'\n', "%0A"}};
  return escapes;
}

const Escapes& property_escapes() {
  static const Escapes escapes{
      {'%', "%25"}, {'\r', "%0D"}, {'\n', "%0A"}, {':', "%3A"}, {',', "%2C"}};
  return escapes;
}

std::string escaped(std::string_view text, const Escapes& escapes) {
  std::string result;
  for (const char c : text) {
    std::string_view replacement(&c, 1);
    for (const auto& [from, to] : escapes) {
      if (c == from) replacement = to;
    }
    result += replacement;
  }
  return result;
}

std::string_view command_of(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "notice";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "error";
}

class GithubReport : public ReportWriter {
 public:
  explicit GithubReport(std::ostream& out) : out_(out) {}

  void map(const MapReport& report) override {
    const std::string file = "file=" + escaped(report.path, property_escapes());
    if (report.unreadable) {
      out_ << "::error " << file
           << ",title=unreadable map::" << escaped(*report.unreadable, message_escapes()) << '\n';
    }
    for (const auto& finding : report.findings) annotate(file, finding);
  }

  void finish() override {}

 private:
  void annotate(const std::string& file, const Finding& finding) {
    const auto& type = finding_type(finding.code);
    out_ << "::" << command_of(finding.severity) << ' ' << file;
    if (finding.place) {
      out_ << ",line=" << finding.place->line << ",col=" << finding.place->column;
    }
    out_ << ",title=" << type.id << ' ' << type.name
         << "::" << escaped(message_text(finding), message_escapes()) << '\n';
  }

  std::ostream& out_;
};

}  // namespace

std::unique_ptr<ReportWriter> make_github_report(std::ostream& out, const ReportOptions&) {
  return std::make_unique<GithubReport>(out);
}

}  // namespace mapwright::validators
