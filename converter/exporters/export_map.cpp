#include "converter/exporters/export_map.hpp"

#include <algorithm>
#include <cctype>

namespace mapwright::converter {

#define MAPWRIGHT_EXPORTER(extension, name, summary) \
  Result<Exported> export_##name(const ExportJob&);
#include "converter/exporters/exporters.def"
#undef MAPWRIGHT_EXPORTER

const std::vector<Exporter>& exporters() {
  static const std::vector<Exporter> all{
#define MAPWRIGHT_EXPORTER(extension, name, summary) {extension, summary, export_##name},
#include "converter/exporters/exporters.def"
#undef MAPWRIGHT_EXPORTER
  };
  return all;
}

const Exporter* exporter_for(std::string_view path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& exporter : exporters()) {
    if (lower.size() > exporter.extension.size() && lower.ends_with(exporter.extension)) {
      return &exporter;
    }
  }
  return nullptr;
}

}  // namespace mapwright::converter
