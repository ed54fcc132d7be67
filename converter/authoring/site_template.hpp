// An authoring template: an empty GeoPackage to draw a site in.
#pragma once

#include <string>

#include "converter/gdal/crs.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

struct SiteTemplate {
  Georeference georeference;  ///< frame of the map that is to come
  Crs crs;                    ///< to draw in; none: transverse Mercator about the origin, metres
  double width_m =
      200.0;  ///< of the border drawn to begin with, along the map's x; its middle is the origin
  double height_m = 200.0;  ///< along the map's y
  double resolution_m = 0.001;
};

/// Writes the GeoPackage at `path`, where no file may be yet: the layers of `template_layers`,
/// their value lists as field domains, defaults, QGIS styles, and one feature, the border, whose
/// fields hold the frame. The same arguments give the same bytes. Fails (kOutput) where it cannot
/// be written, (kInput) where the CRS has no place for the border.
Result<void> write_site_template(const std::string& path, const SiteTemplate& site);

}  // namespace mapwright::converter
