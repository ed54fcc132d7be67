#include "converter/exporters/gis/placed_layers.hpp"

#include "converter/exchange/fields.hpp"
#include "converter/exporters/gis/placement.hpp"
#include "converter/frame/frame_wkt.hpp"
#include "converter/gdal/crs.hpp"
#include "mapcore/text/map_resolution.hpp"

namespace mapwright::converter {
namespace {

constexpr const char* kNoPlace =
    "the map has no georeference (no sidecar beside it): coordinates are metres of its own frame";

PlacedLayers in_map_frame(const ExportJob& job, double resolution_m, bool join_holes) {
  PlacedLayers placed;
  placed.layers = gis_layers(job.map, job.georeference,
                             {std::string(kMapCoordinates), resolution_m, join_holes});
  if (job.georeference)
    placed.crs = frame_wkt2(*job.georeference);
  else
    placed.warnings.emplace_back(kNoPlace);
  return placed;
}

Result<PlacedLayers> in_crs(const ExportJob& job, const std::string& definition,
                            double resolution_m, bool join_holes) {
  const auto crs = parse_crs(definition);
  if (!crs) return usage_failure("--crs: " + crs.error().message);
  PlacedLayers placed;
  placed.crs = crs->wkt;
  placed.layers = gis_layers(job.map, job.georeference, {crs->code, resolution_m, join_holes});
  auto done = place(placed.layers, *job.georeference, *crs, resolution_m);
  if (!done) return tl::unexpected(done.error());
  return placed;
}

}  // namespace

std::string usual_crs(const Georeference& georeference) {
  std::string crs;
  for (const auto& source : georeference.sources) {
    if (source.crs.empty() || (!crs.empty() && crs != source.crs)) return kWgs84;
    crs = source.crs;
  }
  const bool is_known = !crs.empty() && parse_crs(crs).has_value();
  return is_known ? crs : kWgs84;
}

Result<PlacedLayers> placed_layers(const ExportJob& job, const std::string& usual,
                                   bool join_holes) {
  const double resolution_m = resolution_of(job.map);
  const bool asked = !job.crs.empty();
  const std::string& crs = asked ? job.crs : usual;
  if (!job.georeference && asked && crs != kMapCoordinates) {
    return usage_failure(
        "--crs: the map has no georeference (no sidecar beside it); only --crs map "
        "can be had");
  }
  if (!job.georeference || crs == kMapCoordinates) {
    return in_map_frame(job, resolution_m, join_holes);
  }
  auto placed = in_crs(job, crs, resolution_m, join_holes);
  if (placed || asked) return placed;
  auto fallback = in_map_frame(job, resolution_m, join_holes);
  fallback.warnings.push_back(placed.error().message + " (that is done now)");
  return fallback;
}

std::size_t count_without_geometry(const std::vector<GisLayer>& layers) {
  std::size_t count = 0;
  for (const auto& layer : layers) {
    for (const auto& feature : layer.features) {
      if (feature.geometry == GisGeometry::kNone) ++count;
    }
  }
  return count;
}

std::vector<std::string> warning_of_empty(const std::vector<GisLayer>& layers,
                                          const std::string& format) {
  const auto count = count_without_geometry(layers);
  if (count == 0) return {};
  return {std::to_string(count) + " obstacles without segments do not come back from " + format};
}

}  // namespace mapwright::converter
