#include "cli/support/findings_text.hpp"

#include "validators/report/text.hpp"

namespace mapwright::cli {

std::string_view display_path(std::string_view path) {
  return path == "-" ? "<stdin>" : path;
}

std::string finding_line(std::string_view path, const Finding& finding) {
  return validators::finding_line(display_path(path), finding);
}

void write_findings(std::ostream& out, std::string_view path,
                    const std::vector<Finding>& findings) {
  for (const auto& finding : findings) out << finding_line(path, finding) << '\n';
}

void report_findings(Console& console, std::string_view path,
                     const std::vector<Finding>& findings) {
  for (const auto& finding : findings) {
    const std::string line = finding_line(path, finding);
    if (finding.severity == Severity::kError) {
      console.complaint(line);
    } else {
      console.note(line);
    }
  }
}

}  // namespace mapwright::cli
