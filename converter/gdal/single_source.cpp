#include "converter/gdal/single_source.hpp"

#include "converter/gdal/csv_reader.hpp"
#include "converter/gdal/dxf_reader.hpp"
#include "converter/indoorgml/indoorgml_reader.hpp"
#include "converter/osm/osm_reader.hpp"

namespace mapwright::converter {

OpenedReader open_single(const GdalInput& input, const DriverNotice& notice) {
  if (is_osm(input.path)) {
    notice("OSM");
    return open_osm(input.path);
  }
  if (is_indoorgml(input.path)) {
    notice("IndoorGML");
    return open_indoorgml(input.path);
  }
  if (is_csv(input.path)) return open_csv(input, notice);
  return is_dxf(input.path) ? open_dxf(input, notice) : open_gdal(input, notice);
}

}  // namespace mapwright::converter
