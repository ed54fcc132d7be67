#include "cli/support/findings_layers.hpp"

#include <ostream>
#include <string>
#include <utility>

#include "cli/support/error.hpp"
#include "cli/support/map_files.hpp"
#include "converter/exporters/findings.hpp"

namespace mapwright::cli {
namespace {

using converter::MapFindings;
using validators::MapReport;
using validators::ReportOptions;
using validators::ReportWriter;

using Format = std::string (*)(const std::vector<MapFindings>&);

std::string geopackage(const std::vector<MapFindings>& maps) {
  return value_or_throw(converter::findings_geopackage(maps));
}

// A sidecar that makes no sense is a finding of its own (C101).
std::optional<Georeference> georeference_of(const std::string& path) {
  auto georeference = read_sidecar(path);
  return georeference ? *std::move(georeference) : std::nullopt;
}

class FindingsLayers : public ReportWriter {
 public:
  FindingsLayers(std::ostream& out, Format format) : out_(out), format_(format) {}

  void map(const MapReport& report) override {
    const std::string path(report.path);
    maps_.push_back({path, report.findings, georeference_of(path)});
  }

  // Not the text, but the sidecar beside it: both must be those that the findings are about.
  bool needs_whole_text() const override { return true; }

  void finish() override { out_ << format_(maps_); }

 private:
  std::ostream& out_;
  Format format_;
  std::vector<MapFindings> maps_;
};

template <Format format>
std::unique_ptr<ReportWriter> make(std::ostream& out, const ReportOptions&) {
  return std::make_unique<FindingsLayers>(out, format);
}

}  // namespace

const std::vector<validators::ReportFormat>& gis_report_formats() {
  static const std::vector<validators::ReportFormat> formats{
      {"gpkg", "for GIS programs: layers of the defects in a GeoPackage", &make<geopackage>, true},
      {"geojson", "for GIS programs: the defects as GeoJSON", &make<converter::findings_geojson>,
       false}};
  return formats;
}

}  // namespace mapwright::cli
