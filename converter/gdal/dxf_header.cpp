#include "converter/gdal/dxf_header.hpp"

#include <cpl_string.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "converter/gdal/dxf_lines.hpp"
#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kHeaderBytes = 1 << 16U;  // some 400 variables of 30 bytes

// By the value of $INSUNITS, 0 to 14.
constexpr std::array<double, 15> kUnits_m{0.0,    0.0254, 0.3048, 1609.344, 0.001,
                                          0.01,   1.0,    1000.0, 2.54e-8,  2.54e-5,
                                          0.9144, 1e-10,  1e-9,   1e-6,     0.1};
constexpr long kDecametre = 15, kHectometre = 16, kSurveyFoot = 21;
constexpr double kSurveyFoot_m = 1200.0 / 3937.0;

std::optional<double> unit_m(long code) {
  if (code > 0 && code < static_cast<long>(kUnits_m.size())) {
    return kUnits_m[static_cast<std::size_t>(code)];
  }
  if (code == kDecametre) return 10.0;
  if (code == kHectometre) return 100.0;
  if (code == kSurveyFoot) return kSurveyFoot_m;
  return std::nullopt;
}

}  // namespace

bool dxf_is_utf8(const std::string& path) {
  const auto content = stored_content(path);
  if (!content) return false;
  const bool ascii = std::all_of(content->begin(), content->end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
  return !ascii && CPLIsUTF8(content->data(), static_cast<int>(content->size())) != 0;
}

std::optional<double> dxf_metres_per_unit(const std::string& path) {
  std::string header(kHeaderBytes, '\0');
  header.resize(StoredFile(path).read(0, header.data(), header.size()));
  const std::string_view text(header);
  const auto at = text.find("$INSUNITS");
  if (at == text.npos || at > text.find("ENDSEC")) return std::nullopt;
  const auto value =
      DxfLines(text.substr(std::min(text.find('\n', at), text.size() - 1) + 1)).next();
  if (!value || value->code != 70) return std::nullopt;
  return unit_m(std::strtol(std::string(value->value).c_str(), nullptr, 10));
}

}  // namespace mapwright::converter
