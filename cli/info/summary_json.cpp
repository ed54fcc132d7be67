#include <nlohmann/json.hpp>

#include "cli/info/summary_output.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const Spread& spread) {
  return {{"min", spread.min},
          {"median", spread.median},
          {"mean", spread.mean},
          {"p95", spread.p95},
          {"max", spread.max}};
}

// Keyed by the number that stands in the file; all six, so that a script need not ask.
Json shape_types_json(const MapSummary& summary, std::size_t ShapeCount::*count) {
  Json result;
  for (std::size_t i = 0; i < summary.by_shape_type.size(); ++i) {
    result[std::to_string(i + 1)] = summary.by_shape_type[i].*count;
  }
  return result;
}

Json extent_json(const Box& extent) {
  if (extent.is_empty()) return nullptr;
  return {extent.min_x, extent.min_y, extent.max_x, extent.max_y};
}

Json circles_json(const MapSummary& summary) {
  Json result{{"radius_m", spread_json(summary.circle_radii_m)}, {"largest", nullptr}};
  if (const auto& largest = summary.largest_circle) {
    result["largest"] = {{"obstacle", largest->obstacle},
                         {"x", largest->circle.center.x},
                         {"y", largest->circle.center.y},
                         {"radius_m", largest->circle.radius_m}};
  }
  return result;
}

Json findings_json(const MapSummary& summary) {
  Json result;
  for (const auto severity : {Severity::kError, Severity::kWarning, Severity::kNote}) {
    result[std::string(to_string(severity))] = summary.findings[static_cast<std::size_t>(severity)];
  }
  return result;
}

void add_compactness(Json& document, const MapSummary& summary) {
  const auto per_m2 = summary.bytes_per_m2();
  document["bytes"] = summary.bytes;
  document["bytes_per_m2"] = per_m2 ? Json(*per_m2) : Json();
  document["bits_per_m2"] = per_m2 ? Json(8.0 * *per_m2) : Json();
  document["report_bytes_per_m2"] = kReportBytesPerM2;
}

}  // namespace

void write_summary_json(std::ostream& out, std::string_view path, const MapSummary& summary,
                        const std::optional<Georeference>& georeference) {
  const Border& border = summary.border;
  Json document{{"schema", "mapwright.info/1"},
                {"path", path},
                {"obstacles", summary.obstacles},
                {"segments", summary.segments},
                {"by_shape_type", shape_types_json(summary, &ShapeCount::obstacles)},
                {"segments_by_shape_type", shape_types_json(summary, &ShapeCount::segments)},
                {"segments_per_obstacle", spread_json(summary.segments_per_obstacle)},
                {"border", {border.left, border.top, border.right, border.bottom}},
                {"area_m2", border.area_m2()},
                {"extent", extent_json(summary.extent)}};
  add_compactness(document, summary);
  document["length_m"] = summary.length_m;
  document["in_out"] = {{"indoor", summary.indoor}, {"outdoor", summary.outdoor}};
  document["height_m"] = spread_json(summary.heights_m);
  document["segments_of_height_0"] = summary.zero_heights;
  document["bounding_circles"] = circles_json(summary);
  document["distinct_semantics"] = summary.distinct_semantics;
  document["findings"] = findings_json(summary);
  document["georeference"] =
      georeference ? Json::parse(format_georeference(*georeference)) : Json();
  out << document.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace mapwright::cli
