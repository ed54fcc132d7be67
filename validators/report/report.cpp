#include "validators/report/report.hpp"

#include <algorithm>

namespace mapwright::validators {

#define MAPWRIGHT_REPORT_FORMAT(name, summary) \
  std::unique_ptr<ReportWriter> make_##name##_report(std::ostream&, const ReportOptions&);
#include "validators/report/report_formats.def"
#undef MAPWRIGHT_REPORT_FORMAT

std::string_view to_string(Interruption interruption) {
  switch (interruption) {
    case Interruption::kNone:
      return {};
    case Interruption::kTimeLimit:
      return "time limit";
    case Interruption::kMemoryLimit:
      return "memory limit";
    case Interruption::kCrash:
      return "crash";
  }
  return {};
}

const std::vector<ReportFormat>& report_formats() {
  static const std::vector<ReportFormat> formats{
#define MAPWRIGHT_REPORT_FORMAT(name, summary) {#name, summary, &make_##name##_report},
#include "validators/report/report_formats.def"
#undef MAPWRIGHT_REPORT_FORMAT
  };
  return formats;
}

const ReportFormat* find_report_format(std::string_view name) {
  const auto& formats = report_formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const ReportFormat& format) { return format.name == name; });
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace mapwright::validators
