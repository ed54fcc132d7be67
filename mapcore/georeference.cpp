#include "mapcore/georeference.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace mapwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "mapwright.georef/1";

/// What is wrong with the sidecar; ends at `parse_georeference`.
struct Malformed {
  std::string message;
};

[[noreturn]] void fail(const std::string& key, const std::string& what) {
  throw Malformed{"georeference: \"" + key + "\" " + what};
}

std::string dotted(const std::string& path, const char* key) {
  return path.empty() ? key : path + "." + key;
}

/// The member `key`, or nullptr. `path` is where `object` stands in the document.
const Json* find_member(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const Json& member(const Json& object, const std::string& path, const char* key) {
  const Json* found = find_member(object, key);
  if (found == nullptr) fail(dotted(path, key), "is missing");
  return *found;
}

double number(const Json& object, const std::string& path, const char* key, double limit) {
  const Json& value = member(object, path, key);
  if (!value.is_number()) fail(dotted(path, key), "must be a number, it is " + value.dump());
  const auto result = value.get<double>();
  if (!(std::abs(result) <= limit)) {
    fail(dotted(path, key), "is " + value.dump() + ", beyond ±" + Json(limit).dump());
  }
  return result;
}

std::string string(const Json& value, const std::string& path) {
  if (!value.is_string()) fail(path, "must be a string, it is " + value.dump());
  return value.get<std::string>();
}

std::string optional_string(const Json& object, const std::string& path, const char* key) {
  const Json* value = find_member(object, key);
  return value == nullptr ? std::string() : string(*value, dotted(path, key));
}

void check_schema(const Json& document) {
  const std::string schema = string(member(document, "", "schema"), "schema");
  if (schema != kSchema) {
    fail("schema", "is \"" + schema + "\", this program reads \"" + std::string(kSchema) + "\"");
  }
}

FrameProjection projection(const Json& document) {
  const std::string name = string(member(document, "", "projection"), "projection");
  const auto found = frame_projection(name);
  if (!found) fail("projection", "is \"" + name + "\"; \"tmerc\" and \"enu\" are known");
  return *found;
}

GeoreferenceSource source(const Json& value, const std::string& path) {
  if (!value.is_object()) fail(path, "must be an object with path, layer and crs");
  return {string(member(value, path, "path"), dotted(path, "path")),
          optional_string(value, path, "layer"), optional_string(value, path, "crs")};
}

std::vector<GeoreferenceSource> sources(const Json& document) {
  std::vector<GeoreferenceSource> result;
  const Json* list = find_member(document, "sources");
  if (list == nullptr) return result;
  if (!list->is_array()) fail("sources", "must be a list");
  for (const Json& value : *list) {
    result.push_back(source(value, "sources[" + std::to_string(result.size()) + "]"));
  }
  return result;
}

Georeference georeference(const Json& document) {
  if (!document.is_object()) throw Malformed{"georeference: the document must be an object"};
  check_schema(document);
  const Json& origin = member(document, "", "origin");
  if (!origin.is_object()) fail("origin", "must be an object with latitude, longitude and height");
  constexpr double kAnyHeight_m = 1e5;
  Georeference result;
  result.origin_latitude_deg = number(origin, "origin", "latitude", 90.0);
  result.origin_longitude_deg = number(origin, "origin", "longitude", 180.0);
  result.origin_height_m = number(origin, "origin", "height", kAnyHeight_m);
  result.heading_deg = number(document, "", "heading_deg", 360.0);
  result.projection = projection(document);
  result.wkt2 = optional_string(document, "", "wkt2");
  result.sources = sources(document);
  return result;
}

}  // namespace

std::string_view to_string(FrameProjection projection) {
  return projection == FrameProjection::kEastNorthUp ? "enu" : "tmerc";
}

std::optional<FrameProjection> frame_projection(std::string_view name) {
  for (const auto projection :
       {FrameProjection::kTransverseMercator, FrameProjection::kEastNorthUp}) {
    if (to_string(projection) == name) return projection;
  }
  return std::nullopt;
}

std::string format_georeference(const Georeference& georeference) {
  Json sources = Json::array();
  for (const auto& source : georeference.sources) {
    sources.push_back({{"path", source.path}, {"layer", source.layer}, {"crs", source.crs}});
  }
  const Json document{{"schema", kSchema},
                      {"origin",
                       {{"latitude", georeference.origin_latitude_deg},
                        {"longitude", georeference.origin_longitude_deg},
                        {"height", georeference.origin_height_m}}},
                      {"heading_deg", georeference.heading_deg},
                      {"projection", to_string(georeference.projection)},
                      {"wkt2", georeference.wkt2},
                      {"sources", sources}};
  // Names of files and layers need not be UTF-8; what is not becomes U+FFFD.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Georeference> parse_georeference(std::string_view json) {
  try {
    return georeference(Json::parse(json));
  } catch (const Malformed& malformed) {
    return input_failure(malformed.message);
  } catch (const Json::exception& error) {
    return input_failure(std::string("georeference: not JSON: ") + error.what());
  }
}

std::string sidecar_path(std::string_view map_path) {
  constexpr std::string_view kExtension = ".txt";
  if (map_path.ends_with(kExtension)) map_path.remove_suffix(kExtension.size());
  return std::string(map_path) + ".georef.json";
}

}  // namespace mapwright
