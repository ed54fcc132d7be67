#include "mapcore/finding.hpp"

#include <algorithm>
#include <tuple>

namespace mapwright {

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "error";
}

const std::vector<FindingType>& finding_catalogue() {
  static const std::vector<FindingType> catalogue{
#define MAPWRIGHT_FINDING(code, name, severity, summary) \
  {FindingCode::code, #code, #name, Severity::severity, summary},
#include "mapcore/finding_catalogue.def"
#undef MAPWRIGHT_FINDING
  };
  return catalogue;
}

const FindingType& finding_type(FindingCode code) {
  return finding_catalogue()[static_cast<std::size_t>(code)];
}

std::optional<FindingCode> finding_code(std::string_view id) {
  for (const auto& type : finding_catalogue()) {
    if (type.id == id) return type.code;
  }
  return std::nullopt;
}

Finding make_finding(FindingCode code, std::string message) {
  return {code, finding_type(code).severity, std::move(message), {}, {}, {}, {}, {}, {}, {}};
}

bool has_errors(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& f) { return f.severity == Severity::kError; });
}

void sort_findings(std::vector<Finding>& findings) {
  const auto key = [](const Finding& f) {
    const auto place = f.place.value_or(TextPlace{SIZE_MAX, SIZE_MAX});
    return std::tuple(place.line, place.column, f.code);
  };
  std::stable_sort(findings.begin(), findings.end(),
                   [&](const Finding& p, const Finding& q) { return key(p) < key(q); });
}

}  // namespace mapwright
