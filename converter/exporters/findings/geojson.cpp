#include <cmath>
#include <nlohmann/json.hpp>

#include "converter/exporters/findings/finding_rows.hpp"

namespace mapwright::converter {
namespace {

using Json = nlohmann::ordered_json;

// 1e-9 degrees are 0.1 mm.
double rounded(double value) {
  return std::round(value * 1e9) / 1e9;
}

Json position_json(Point p) {
  return Json::array({rounded(p.x), rounded(p.y)});
}

Json positions_json(const std::vector<Point>& path) {
  Json json = Json::array();
  for (const Point p : path) json.push_back(position_json(p));
  return json;
}

Json geometry_json(const FindingRow& row) {
  if (row.paths.empty()) return nullptr;
  constexpr std::array<const char*, 3> kTypes{"MultiPoint", "MultiLineString", "MultiPolygon"};
  Json coordinates = Json::array();
  for (const auto& path : row.paths) {
    switch (row.part) {
      case FindingPart::kPoints:
        coordinates.push_back(position_json(path.front()));
        break;
      case FindingPart::kLines:
        coordinates.push_back(positions_json(path));
        break;
      case FindingPart::kAreas:
        coordinates.push_back(Json::array({positions_json(path)}));
        break;
    }
  }
  return {{"type", kTypes[static_cast<std::size_t>(row.part)]},
          {"coordinates", std::move(coordinates)}};
}

Json value_json(const FindingValue& value) {
  return std::visit(
      [](const auto& known) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(known)>, std::monostate>) {
          return nullptr;
        } else {
          return known;
        }
      },
      value);
}

Json feature_json(const FindingRow& row) {
  Json properties = Json::object();
  const auto values = values_of(row);
  for (std::size_t i = 0; i < values.size(); ++i) {
    properties[std::string(kFindingColumns[i].name)] = value_json(values[i]);
  }
  return {
      {"type", "Feature"}, {"properties", std::move(properties)}, {"geometry", geometry_json(row)}};
}

}  // namespace

// RFC 7946 knows longitude and latitude only and has no word for other coordinates; the
// specification of 2008 before it has "crs": null, and readers of GIS still know it.
std::string findings_geojson(const std::vector<MapFindings>& maps) {
  const FindingFrame frame = frame_of(maps, true);
  std::string text = "{\"type\": \"FeatureCollection\",\n\"name\": \"findings\",\n";
  if (frame == FindingFrame::kMetres) text += "\"crs\": null,\n";
  text += "\"features\": [";
  const char* separator = "\n";
  for (const auto& row : finding_rows(maps, frame)) {
    text += separator;
    text += feature_json(row).dump(-1, ' ', false, Json::error_handler_t::replace);
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace mapwright::converter
