#include "converter/pipeline/recorded_frame.hpp"

#include <algorithm>
#include <cmath>

#include "converter/exchange/exchange_fields.hpp"
#include "converter/exchange/fields.hpp"
#include "converter/rules/pattern.hpp"

namespace mapwright::converter {
namespace {

namespace field = exchange_field;

bool has_field(const LayerInfo& layer, std::string_view name) {
  return std::any_of(layer.fields.begin(), layer.fields.end(),
                     [&](const std::string& own) { return folded(own) == name; });
}

// Layers in which the border may stand.
bool may_hold_border(const VectorSource& source, const LayerInfo& layer) {
  if (has_field(layer, field::kVersion)) return true;
  return source.driver() == "DXF" && folded(layer.name) == kBorderShape;
}

bool is_place(double latitude_deg, double longitude_deg, double heading_deg) {
  return std::abs(latitude_deg) <= 90.0 && std::abs(longitude_deg) <= 180.0 &&
         std::abs(heading_deg) <= 360.0;
}

Result<RecordedFrame> read_frame(const ExchangeFields& fields, const std::string& place) {
  RecordedFrame frame;
  frame.crs = fields.text(field::kCrs).value_or("");
  frame.map_coordinates = frame.crs == kMapCoordinates;
  frame.resolution_m = fields.number(field::kResolution);
  if (frame.resolution_m && !(*frame.resolution_m >= 1e-9 && *frame.resolution_m <= 10.0)) {
    return input_failure(place + ": the border's resolution must be from 1e-9 to 10 m");
  }
  const std::string name = fields.text(field::kFrame).value_or("");
  if (name == kLocalFrame) return frame;
  const auto projection = frame_projection(name);
  const auto latitude = fields.number(field::kOriginLatitude);
  const auto longitude = fields.number(field::kOriginLongitude);
  const auto heading = fields.number(field::kHeading);
  if (!projection || !latitude || !longitude || !heading ||
      !is_place(*latitude, *longitude, *heading)) {
    return input_failure(place +
                         ": the border says of the map's frame what makes no sense: frame must be "
                         "tmerc, enu or local, with origin_lat, origin_lon and heading in degrees; "
                         "mend them, or delete the field mapwright and give --origin");
  }
  Georeference georeference;
  georeference.projection = *projection;
  georeference.origin_latitude_deg = *latitude;
  georeference.origin_longitude_deg = *longitude;
  georeference.origin_height_m = fields.number(field::kOriginHeight).value_or(0.0);
  georeference.heading_deg = *heading;
  frame.georeference = georeference;
  return frame;
}

}  // namespace

bool is_exported(const LayerInfo& layer) {
  return has_field(layer, field::kPos) && has_field(layer, field::kShape);
}

Result<std::optional<RecordedFrame>> recorded_frame(VectorSource& source) {
  for (std::size_t i = 0; i < source.layers().size(); ++i) {
    const auto& layer = source.layers()[i];
    if (!may_hold_border(source, layer)) continue;
    ExchangeFields fields(layer.fields);
    std::optional<Result<RecordedFrame>> found;
    ReadOptions options;
    options.keep_broken = true;  // what is broken shows when the layer is converted
    const auto count = source.read(i, options, [&](SourceFeature& feature) {
      if (found) return;
      fields.load(feature);
      if (!fields.integer(field::kVersion)) return;
      found = read_frame(fields, source.path() + ": layer " + layer.name);
    });
    if (!found) continue;
    if (!*found) return tl::unexpected(found->error());
    return std::optional(**std::move(found));
  }
  return std::optional<RecordedFrame>();
}

}  // namespace mapwright::converter
