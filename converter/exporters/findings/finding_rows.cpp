#include "converter/exporters/findings/finding_rows.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "converter/frame/local_frame.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

bool same_frame(const Georeference& p, const Georeference& q) {
  return p.origin_latitude_deg == q.origin_latitude_deg &&
         p.origin_longitude_deg == q.origin_longitude_deg &&
         p.origin_height_m == q.origin_height_m && p.heading_deg == q.heading_deg &&
         p.projection == q.projection;
}

using Paths = std::vector<std::vector<Point>>;

/// From the coordinates of one map to those of the file.
class Placement {
 public:
  Placement(const MapFindings& map, FindingFrame frame)
      : has_place_(frame == FindingFrame::kMetres || map.georeference) {
    if (frame == FindingFrame::kWgs84 && map.georeference) {
      frame_ = std::make_unique<LocalFrame>(*map.georeference);
    }
  }

  Paths placed(Paths paths) const {
    if (!has_place_) return {};
    if (!frame_) return paths;
    for (auto& path : paths) {
      for (Point& p : path) {
        const GeoPoint place = frame_->to_wgs84(p);
        p = {place.longitude_deg, place.latitude_deg};
      }
    }
    return paths;
  }

 private:
  bool has_place_;
  std::unique_ptr<LocalFrame> frame_;
};

Paths points_of(const Finding& finding) {
  Paths paths;
  for (const Point p : finding.geometry.points) paths.push_back({p});
  if (!paths.empty()) return paths;
  if (finding.at) return {{*finding.at}};
  for (const auto* others : {&finding.geometry.lines, &finding.geometry.areas}) {
    if (!others->empty()) return {{others->front().front()}};
  }
  return {};
}

Paths rings_of(const Finding& finding) {
  Paths rings = finding.geometry.areas;
  for (auto& ring : rings) {
    if (signed_area_m2(ring) < 0.0) std::reverse(ring.begin(), ring.end());
    ring.push_back(ring.front());
  }
  return rings;
}

std::string source_text(const std::vector<GisFeature>& features) {
  std::string text;
  for (const auto& feature : features) {
    text += (text.empty() ? "layer " : "; layer ") + feature.layer + ", feature " +
            std::to_string(feature.fid);
    if (!feature.source.empty()) text += " of " + feature.source;
  }
  return text;
}

FindingValue integer(auto value) {
  return static_cast<std::int64_t>(value);
}

}  // namespace

FindingFrame frame_of(const std::vector<MapFindings>& maps, bool only_wgs84) {
  const auto has_place = [](const MapFindings& map) { return map.georeference.has_value(); };
  const auto first = std::find_if(maps.begin(), maps.end(), has_place);
  if (first == maps.end()) return FindingFrame::kMetres;
  const bool are_one = std::all_of(maps.begin(), maps.end(), [&](const MapFindings& map) {
    return !map.georeference || same_frame(*map.georeference, *first->georeference);
  });
  return are_one && !only_wgs84 ? FindingFrame::kMapFrame : FindingFrame::kWgs84;
}

std::vector<FindingRow> finding_rows(const std::vector<MapFindings>& maps, FindingFrame frame) {
  std::vector<FindingRow> rows;
  std::size_t number = 0;
  for (const auto& map : maps) {
    const Placement placement(map, frame);
    for (const auto& finding : map.findings) {
      ++number;
      const auto add = [&](FindingPart part, Paths paths) {
        rows.push_back({number, &map, &finding, part, placement.placed(std::move(paths))});
      };
      add(FindingPart::kPoints, points_of(finding));
      if (!finding.geometry.lines.empty()) add(FindingPart::kLines, finding.geometry.lines);
      if (!finding.geometry.areas.empty()) add(FindingPart::kAreas, rings_of(finding));
    }
  }
  return rows;
}

std::array<FindingValue, kFindingColumns.size()> values_of(const FindingRow& row) {
  const Finding& finding = *row.finding;
  const auto& type = finding_type(finding.code);
  const auto& place = finding.place;
  const auto x = finding.at ? FindingValue(finding.at->x) : FindingValue();
  const auto y = finding.at ? FindingValue(finding.at->y) : FindingValue();
  const std::string source = source_text(finding.features);
  return {static_cast<std::int64_t>(row.number),
          row.map->map,
          std::string(type.id),
          std::string(type.name),
          std::string(to_string(finding.severity)),
          finding.message,
          place ? integer(place->line) : FindingValue(),
          place ? integer(place->column) : FindingValue(),
          x,
          y,
          finding.obstacle ? integer(*finding.obstacle) : FindingValue(),
          finding.segment ? integer(*finding.segment) : FindingValue(),
          source.empty() ? FindingValue() : FindingValue(source)};
}

}  // namespace mapwright::converter
