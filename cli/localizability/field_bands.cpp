#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cli/localizability/field_layers.hpp"
#include "validators/deployment/localizability_findings.hpp"

namespace mapwright::cli {
namespace {

using converter::FieldBand;
using navcore::HeadingAccuracy;
using navcore::LocalizabilityField;

template <class Value>
FieldBand band(const LocalizabilityField& field, const char* name, const char* what,
               Value&& value) {
  FieldBand result{name, what, {}};
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    result.values.push_back(field.stands[i] != 0 ? static_cast<float>(value(i))
                                                 : std::numeric_limits<float>::quiet_NaN());
  }
  return result;
}

double bounded(double deviation) {
  return std::min(deviation, kUnknownDeviation);
}

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

}  // namespace

converter::Field field_bands(const LocalizabilityField& field, AtHeading at) {
  const auto& accuracy = field.accuracy;
  const auto chosen = [&](std::size_t i) -> const HeadingAccuracy& {
    return at == AtHeading::kWorst ? accuracy[i].worst : accuracy[i].median;
  };
  const auto edges = [&](std::size_t i) {
    return (at == AtHeading::kWorst ? accuracy[i].edges_worst : accuracy[i].edges_median)
        .with_edges.major_m;
  };
  return {field.grid.corner,
          field.grid.cell_m,
          field.grid.columns,
          field.grid.rows,
          {band(field, "position_sd_major_m",
                "least standard deviation of the position in the direction known least, metres "
                "(Cramer-Rao); 1000: unknown",
                [&](std::size_t i) { return bounded(chosen(i).bound.major_m); }),
           band(field, "position_sd_minor_m", "the same across that direction",
                [&](std::size_t i) { return bounded(chosen(i).bound.minor_m); }),
           band(field, "direction_deg",
                "direction known least, degrees counter-clockwise from the map's +x, -90 to 90",
                [&](std::size_t i) { return chosen(i).bound.major_direction.degrees(); }),
           band(field, "heading_sd_deg",
                "least standard deviation of the heading, degrees; 1000: unknown",
                [&](std::size_t i) { return bounded(degrees(chosen(i).bound.heading_rad)); }),
           band(field, "with_edges_major_m",
                "position_sd_major_m when edges of things count too, as for a filter",
                [&](std::size_t i) { return bounded(edges(i)); }),
           band(field, "alias_risk",
                "least probability to mistake a scan for one of the most similar other place, of "
                "these two, 0 to 0.5",
                [&](std::size_t i) {
                  return at == AtHeading::kWorst ? field.worst_risk(i) : field.median_risk(i);
                }),
           band(field, "alias_distance_m", "how far away that place is, metres; 0: none found",
                [&](std::size_t i) {
                  const auto& twins = field.twins[i];
                  const auto& twin = at == AtHeading::kWorst ? twins.worst : twins.median;
                  return twin ? distance(field.grid.center(i), twin->pose.position()) : 0.0;
                }),
           band(field, "robot_heading_deg", "heading of the robot that the first four are for",
                [&](std::size_t i) { return chosen(i).heading_deg; })}};
}

converter::GisLayer weak_area_layer(const LocalizabilityField& field,
                                    const std::vector<navcore::WeakArea>& areas,
                                    const converter::Field& bands) {
  using converter::FieldValue;
  using converter::GisType;
  converter::GisLayer layer{"weak_areas",
                            converter::GisGeometry::kPolygon,
                            {{"kind", GisType::kText},
                             {"area_m2", GisType::kReal},
                             {"accuracy_m", GisType::kReal},
                             {"risk", GisType::kReal},
                             {"message", GisType::kText}},
                            {}};
  for (const auto& area : areas) {
    const bool inaccurate = area.weakness == navcore::Weakness::kInaccurate;
    for (auto& polygon : converter::cell_polygons(bands, area.cells)) {
      converter::GisFeature feature;
      feature.geometry = converter::GisGeometry::kPolygon;
      feature.paths = std::move(polygon);
      feature.values.emplace_back(std::string(inaccurate ? "inaccurate" : "confusable"));
      feature.values.emplace_back(area.area_m2);
      feature.values.emplace_back(bounded(area.accuracy_m));
      feature.values.emplace_back(area.risk);
      feature.values.emplace_back(validators::weak_area_text(field, area));
      layer.features.push_back(std::move(feature));
    }
  }
  return layer;
}

}  // namespace mapwright::cli
