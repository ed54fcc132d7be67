#include "converter/gdal/gml_geometry.hpp"

#include <ogr_api.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>

#include <memory>

#include "converter/gdal/crs_of.hpp"
#include "converter/gdal/geometry_paths.hpp"
#include "converter/gdal/messages.hpp"

namespace mapwright::converter {

std::string append_gml(const std::string& element, double sagitta, SourceGeometry& paths) {
  GdalMessages messages;
  const std::unique_ptr<OGRGeometry> geometry(OGRGeometryFactory::createFromGML(element.c_str()));
  if (!geometry) {
    return messages.has_error() ? messages.first_error() : std::string("it is no GML geometry");
  }
  append_paths(geometry.get(), sagitta, paths);
  return {};
}

GmlCrs gml_crs(const std::string& srs_name) {
  const GdalMessages quiet;
  GmlCrs found;
  auto crs = parse_crs(srs_name);
  if (!crs) return found;
  found.crs = *std::move(crs);
  OGRSpatialReference reference;
  if (reference.importFromWkt(found.crs.wkt.c_str()) != OGRERR_NONE) return found;
  const bool by_authority =
      srs_name.starts_with("urn:") || srs_name.find("opengis.net/def/crs") != srs_name.npos;
  found.north_first = by_authority && (reference.EPSGTreatsAsLatLong() != 0 ||
                                       reference.EPSGTreatsAsNorthingEasting() != 0);
  return found;
}

}  // namespace mapwright::converter
