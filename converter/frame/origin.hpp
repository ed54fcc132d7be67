// From what a person says about the frame to a georeference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/gdal/crs.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// The options --origin, --origin-crs, --heading and --frame.
struct FrameOptions {
  std::vector<double> origin;  ///< latitude, longitude and perhaps height; in a CRS: x, y. Or empty
  std::string origin_crs;      ///< empty: WGS 84
  double heading_deg =
      0.0;  ///< of +y, clockwise from true north, or from the grid's with origin_crs
  FrameProjection projection = FrameProjection::kTransverseMercator;
};

/// The georeference of the options; without origin at `fallback_latitude`/`longitude`. Fails
/// (kUsage) where the origin is no place on Earth.
Result<Georeference> resolve_frame(const FrameOptions& options, double fallback_latitude_deg,
                                   double fallback_longitude_deg);

/// Azimuth of the grid's north at a place of a projected CRS: degrees clockwise from true north.
double grid_north_deg(const CrsTransform& crs, double x, double y);

}  // namespace mapwright::converter
