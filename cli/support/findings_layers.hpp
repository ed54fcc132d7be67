// Reports as layers for GIS programs.
#pragma once

#include <vector>

#include "validators/report/report.hpp"

namespace mapwright::cli {

/// The formats gpkg and geojson. Their writers look for the sidecar of each map when it is
/// reported, keep all findings and write when finished; `finish` throws Error (kOutput).
const std::vector<validators::ReportFormat>& gis_report_formats();

}  // namespace mapwright::cli
