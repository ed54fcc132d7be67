#include "converter/exporters/gis/gis_layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "converter/exchange/fields.hpp"
#include "converter/exporters/gis/ring_groups.hpp"
#include "converter/exporters/gis/style_fields.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

namespace field = exchange_field;
using Json = nlohmann::ordered_json;

// Beyond this not every format keeps a whole number as a number.
constexpr std::int64_t kLargestNumber = 999'999'999'999'999;

// Fields of a layer by name; those no feature fills in are left out at the end.
class LayerBuilder {
 public:
  LayerBuilder(std::string name, GisGeometry geometry, std::vector<GisColumn> columns)
      : layer_{std::move(name), geometry, std::move(columns), {}} {
    for (std::size_t i = 0; i < layer_.columns.size(); ++i) position_[layer_.columns[i].name] = i;
    is_used_.assign(layer_.columns.size(), false);
  }

  GisFeature& add(GisGeometry geometry) {
    layer_.features.push_back({geometry, {}, {}, 0.0});
    layer_.features.back().values.resize(layer_.columns.size());
    return layer_.features.back();
  }

  void set(std::string_view name, FieldValue value) {
    if (const auto* text = std::get_if<std::string>(&value); text != nullptr && text->empty()) {
      return;
    }
    const std::size_t i = position_.find(name)->second;
    if (layer_.columns[i].type == GisType::kText && std::holds_alternative<std::int64_t>(value)) {
      value = std::to_string(std::get<std::int64_t>(value));
    }
    is_used_[i] = true;
    layer_.features.back().values[i] = std::move(value);
  }
  bool has(std::string_view name) const { return position_.find(name) != position_.end(); }

  /// Keeps the first `always` columns and those in use.
  GisLayer finish(std::size_t always) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < layer_.columns.size(); ++i) {
      if (i < always || is_used_[i]) kept.push_back(i);
    }
    keep(kept);
    return std::move(layer_);
  }

 private:
  void keep(const std::vector<std::size_t>& kept) {
    std::vector<GisColumn> columns;
    for (const std::size_t i : kept) columns.push_back(layer_.columns[i]);
    for (auto& feature : layer_.features) {
      std::vector<FieldValue> values;
      values.reserve(kept.size());
      for (const std::size_t i : kept) values.push_back(std::move(feature.values[i]));
      feature.values = std::move(values);
    }
    layer_.columns = std::move(columns);
  }

  GisLayer layer_;
  std::map<std::string, std::size_t, std::less<>> position_;
  std::vector<bool> is_used_;
};

// Keys of the map's tokens that get a field, in alphabetical order.
std::set<std::string, std::less<>> token_keys(const Map& map) {
  std::set<std::string, std::less<>> keys;
  for (const auto& obstacle : map.obstacles) {
    for (const auto token : obstacle.semantic.tokens()) {
      const auto equals = token.find('=');
      if (equals == token.npos) continue;
      const auto key = token.substr(0, equals);
      if (can_be_token_field(key) && keys.find(key) == keys.end()) keys.emplace(key);
    }
  }
  return keys;
}

constexpr std::size_t kCoreColumns = 8;

std::vector<GisColumn> obstacle_columns(const Map& map) {
  bool large = false;
  for (const auto& o : map.obstacles)
    large = large || o.id > kLargestNumber || o.id < -kLargestNumber;
  std::vector<GisColumn> columns;
  const auto add = [&](std::string_view name, GisType type) {
    columns.push_back({std::string(name), type});
  };
  add(field::kId, large ? GisType::kText : GisType::kInteger);
  add(field::kPos, GisType::kInteger);
  add(field::kShape, GisType::kText);
  add(field::kKind, GisType::kText);
  add(field::kHeight, GisType::kReal);
  add(field::kInOut, GisType::kText);
  add(field::kSemantic, GisType::kText);
  add(field::kSegmentSemantic, GisType::kText);
  add(field::kPart, GisType::kInteger);
  for (const auto name : {field::kFreeSide, field::kRuns, field::kHeights, field::kInOuts,
                          field::kSegmentSemantics, field::kHoles}) {
    add(name, GisType::kText);
  }
  for (const auto& key : token_keys(map)) add(key, GisType::kText);
  return columns;
}

class MapLayers {
 public:
  MapLayers(const Map& map, bool join_holes)
      : map_(map),
        groups_(ring_groups(map, join_holes)),
        columns_(obstacle_columns(map)),
        solids_("solids", GisGeometry::kPolygon, columns_),
        walls_("walls", GisGeometry::kLine, columns_),
        steps_("steps", GisGeometry::kLine, columns_),
        ramps_("ramps", GisGeometry::kPolygon, columns_) {}

  void append_to(std::vector<GisLayer>& layers) {
    for (std::size_t i = 0; i < map_.obstacles.size(); ++i) {
      if (groups_.outer_of[i] != RingGroups::kNone) continue;
      groups_.is_ring[i] ? add_polygon(i) : add_lines(i);
    }
    for (auto* layer : {&solids_, &walls_, &steps_, &ramps_}) {
      layers.push_back(layer->finish(kCoreColumns));
    }
  }

 private:
  static std::int64_t position(std::size_t i) { return static_cast<std::int64_t>(i) + 1; }

  void set_identity(LayerBuilder& layer, std::size_t i) const {
    const auto& obstacle = map_.obstacles[i];
    layer.set(field::kId, obstacle.id);
    layer.set(field::kPos, position(i));
    layer.set(field::kShape, std::string(shape_name(obstacle.shape_type)));
    layer.set(field::kSemantic, obstacle.semantic.str());
    bool has_kind = false;
    for (const auto token : obstacle.semantic.tokens()) {
      const auto equals = token.find('=');
      if (equals == token.npos && !has_kind && !token.empty()) {
        layer.set(field::kKind, std::string(token));
        has_kind = true;
      }
      const auto key = token.substr(0, equals);
      if (equals == token.npos || !can_be_token_field(key) || !layer.has(key)) continue;
      layer.set(key, std::string(*obstacle.semantic.value(key)));
    }
  }

  void add_polygon(std::size_t i) {
    const auto& obstacle = map_.obstacles[i];
    LayerBuilder& layer = obstacle.shape_type == ShapeType::kRamp ? ramps_ : solids_;
    auto& feature = layer.add(GisGeometry::kPolygon);
    feature.height_m = max_height_m(obstacle);
    feature.paths.push_back(chain_points(obstacle));
    for (const std::size_t hole : groups_.holes[i]) {
      feature.paths.push_back(chain_points(map_.obstacles[hole]));
    }
    set_identity(layer, i);
    layer.set(field::kFreeSide, free_side(obstacle));
    for (auto& [name, value] : style_fields(obstacle.segments)) layer.set(name, std::move(value));
    if (!groups_.holes[i].empty()) layer.set(field::kHoles, holes_text(i));
  }

  static std::string free_side(const Obstacle& obstacle) {
    const bool inside = ring_orientation(chain_points(obstacle)) == RingOrientation::kClockwise;
    return inside ? "inside" : "outside";
  }

  // What holes have that does not follow from their outline.
  std::string holes_text(std::size_t outer) const {
    Json list = Json::array();
    for (const std::size_t hole : groups_.holes[outer]) list.push_back(hole_record(outer, hole));
    // Bytes that are no UTF-8 are errors of the map already; no GIS takes them.
    return list.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  Json hole_record(std::size_t outer, std::size_t hole) const {
    const auto& outline = map_.obstacles[outer];
    const auto& inner = map_.obstacles[hole];
    Json record{{"id", inner.id}, {"pos", position(hole)}};
    if (inner.shape_type != outline.shape_type) {
      record["shape"] = shape_name(inner.shape_type);
    }
    const auto usual =
        outline.semantic.with_value(semantic_key::kInnerOf, std::to_string(outline.id));
    if (inner.semantic != usual) record["semantic"] = inner.semantic.view();
    const auto of_outline = style_fields(outline.segments);
    const auto of_inner = style_fields(inner.segments);
    if (of_outline == of_inner && of_outline.size() == 3) return record;
    for (const auto& [name, value] : of_inner) {
      if (const auto* number = std::get_if<double>(&value)) record[std::string(name)] = *number;
      if (const auto* text = std::get_if<std::string>(&value)) record[std::string(name)] = *text;
    }
    return record;
  }

  void add_lines(std::size_t i) {
    const auto& obstacle = map_.obstacles[i];
    LayerBuilder& layer = obstacle.shape_type == ShapeType::kStairs ? steps_ : walls_;
    const std::span<const Segment> all(obstacle.segments);
    if (all.empty()) {
      layer.add(GisGeometry::kNone);
      return set_identity(layer, i);
    }
    std::int64_t part = 0;
    for (std::size_t first = 0; first < all.size();) {
      std::size_t last = first + 1;
      while (last < all.size() && all[last - 1].b == all[last].a &&
             same_style(all[first], all[last])) {
        ++last;
      }
      add_part(layer, i, all.subspan(first, last - first), ++part);
      first = last;
    }
  }

  void add_part(LayerBuilder& layer, std::size_t i, std::span<const Segment> run,
                std::int64_t part) {
    auto& feature = layer.add(GisGeometry::kLine);
    feature.height_m = run.front().height_m;
    feature.paths.emplace_back();
    for (const auto& segment : run) feature.paths.front().push_back(segment.a);
    feature.paths.front().push_back(run.back().b);
    set_identity(layer, i);
    layer.set(field::kPart, part);
    for (auto& [name, value] : style_fields(run)) layer.set(name, std::move(value));
  }

  const Map& map_;
  RingGroups groups_;
  std::vector<GisColumn> columns_;
  LayerBuilder solids_, walls_, steps_, ramps_;
};

std::vector<GisColumn> border_columns() {
  return {{std::string(field::kVersion), GisType::kInteger},
          {std::string(field::kShape), GisType::kText},
          {std::string(field::kFrame), GisType::kText},
          {std::string(field::kCrs), GisType::kText},
          {std::string(field::kOriginLatitude), GisType::kReal},
          {std::string(field::kOriginLongitude), GisType::kReal},
          {std::string(field::kOriginHeight), GisType::kReal},
          {std::string(field::kHeading), GisType::kReal},
          {std::string(field::kResolution), GisType::kReal}};
}

GisLayer border_layer(const Border& border, const std::optional<Georeference>& georeference,
                      const std::string& crs, double resolution_m) {
  LayerBuilder layer("border", GisGeometry::kPolygon, border_columns());
  layer.add(GisGeometry::kPolygon)
      .paths.push_back({{border.left, border.top},
                        {border.left, border.bottom},
                        {border.right, border.bottom},
                        {border.right, border.top}});
  layer.set(field::kVersion, std::int64_t{1});
  layer.set(field::kShape, std::string(kBorderShape));
  layer.set(field::kCrs, crs);
  layer.set(field::kResolution, resolution_m);
  if (!georeference) {
    layer.set(field::kFrame, std::string(kLocalFrame));
    return layer.finish(0);
  }
  layer.set(field::kFrame, std::string(to_string(georeference->projection)));
  layer.set(field::kOriginLatitude, georeference->origin_latitude_deg);
  layer.set(field::kOriginLongitude, georeference->origin_longitude_deg);
  layer.set(field::kOriginHeight, georeference->origin_height_m);
  layer.set(field::kHeading, georeference->heading_deg);
  return layer.finish(0);
}

// Moves all features of `from` into `to`, which gets the columns it lacks.
void merge_into(GisLayer& to, GisLayer from) {
  std::vector<std::size_t> target;
  for (auto& column : from.columns) {
    const auto same = [&](const GisColumn& c) { return c.name == column.name; };
    const auto found = std::find_if(to.columns.begin(), to.columns.end(), same);
    target.push_back(static_cast<std::size_t>(found - to.columns.begin()));
    if (found == to.columns.end()) to.columns.push_back(std::move(column));
  }
  for (auto& feature : to.features) feature.values.resize(to.columns.size());
  for (auto& feature : from.features) {
    std::vector<FieldValue> values(to.columns.size());
    for (std::size_t i = 0; i < target.size(); ++i) {
      values[target[i]] = std::move(feature.values[i]);
    }
    feature.values = std::move(values);
    to.features.push_back(std::move(feature));
  }
}

}  // namespace

std::vector<GisLayer> gis_layers(const Map& map, const std::optional<Georeference>& georeference,
                                 const GisLayerOptions& options) {
  std::vector<GisLayer> layers;
  layers.push_back(border_layer(map.border, georeference, options.crs, options.resolution_m));
  MapLayers(map, options.join_holes).append_to(layers);
  return layers;
}

GisLayer in_one_layer(std::vector<GisLayer> layers, const std::string& name) {
  GisLayer all{name, layers.front().geometry, {}, {}};
  for (auto& layer : layers) merge_into(all, std::move(layer));
  return all;
}

std::vector<GisLayer> by_geometry(std::vector<GisLayer> layers) {
  std::vector<GisLayer> polygons, lines;
  for (auto& layer : layers) {
    (layer.geometry == GisGeometry::kPolygon ? polygons : lines).push_back(std::move(layer));
  }
  std::vector<GisLayer> both;
  both.push_back(in_one_layer(std::move(polygons), "polygons"));
  both.push_back(in_one_layer(std::move(lines), "lines"));
  return both;
}

}  // namespace mapwright::converter
