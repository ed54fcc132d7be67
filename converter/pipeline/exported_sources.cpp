#include "converter/pipeline/exported_sources.hpp"

#include <filesystem>

#include "converter/exchange/fields.hpp"
#include "converter/frame/frame_wkt.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

bool same_frame(const Georeference& p, const Georeference& q) {
  return p.origin_latitude_deg == q.origin_latitude_deg &&
         p.origin_longitude_deg == q.origin_longitude_deg &&
         p.origin_height_m == q.origin_height_m && p.heading_deg == q.heading_deg &&
         p.projection == q.projection;
}

}  // namespace

bool keeps_recorded_frame(const ConvertOptions& options) {
  const FrameOptions& frame = options.frame;
  return !options.local && frame.origin.empty() && frame.heading_deg == 0.0 &&
         frame.projection == FrameOptions().projection;
}

std::string place_of_export(const VectorSource& source, const LayerInfo& layer) {
  if (source.driver() != "ESRI Shapefile") return source.path();
  std::error_code error;
  const fs::path path(source.path());
  const fs::path folder = fs::is_directory(path, error) ? path : path.parent_path();
  std::string name = layer.name;
  if (name.ends_with(kLinesSuffix)) name.resize(name.size() - kLinesSuffix.size());
  return (folder / name).string();
}

Result<void> take_recorded(const RecordedFrame& frame, const ConvertOptions& options,
                           const OpenedSources& opened, LayerJob& job) {
  if (options.local) return {};
  if (!frame.map_coordinates) {
    if (job.crs.is_stated() || frame.crs.empty()) return {};
    const auto crs = parse_crs(frame.crs);
    if (crs) job.crs = *crs;
    return {};
  }
  job.is_map_frame = true;
  job.crs = {};
  if (!frame.georeference) return {};
  const bool is_frame_of_map = keeps_recorded_frame(options) && opened.frame->georeference &&
                               same_frame(*frame.georeference, *opened.frame->georeference);
  if (is_frame_of_map) return {};
  auto crs = parse_crs(frame_wkt2(*frame.georeference));
  if (!crs) return tl::unexpected(crs.error());
  job.crs = *std::move(crs);
  return {};
}

std::string lines_beside(const VectorSource& source, const ConvertOptions& options) {
  const fs::path path(source.path());
  std::error_code error;
  if (source.driver() != "ESRI Shapefile" || !fs::is_regular_file(path, error)) return {};
  const fs::path lines =
      path.parent_path() / (path.stem().string() + std::string(kLinesSuffix) + ".shp");
  if (!fs::exists(lines, error)) return {};
  for (const auto& other : options.sources) {
    if (fs::equivalent(other, lines, error)) return {};
  }
  return lines.string();
}

}  // namespace mapwright::converter
