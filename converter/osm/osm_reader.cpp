#include "converter/osm/osm_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>
#include <utility>

#include "converter/gdal/stored_file.hpp"
#include "converter/osm/osm_areas.hpp"
#include "converter/osm/osm_data.hpp"
#include "converter/osm/osm_layers.hpp"
#include "converter/source/document_reader.hpp"

namespace mapwright::converter {
namespace {

using Form = OsmItem::Form;
using NodePair = std::pair<std::int64_t, std::int64_t>;

NodePair unordered(std::int64_t a, std::int64_t b) {
  return {std::min(a, b), std::max(a, b)};
}

// Makes features of the objects of one layer, in order.
class FeatureMaker {
 public:
  FeatureMaker(const OsmData& data, const OsmLayer& layer) : data_(data) {
    for (const auto& item : layer.items) {
      if (item.form == Form::kPassage) add_edges(data.ways[item.index], taken_);
    }
    if (layer.name != "multipolygons") return;
    way_numbers_ = member_ways(data);
  }

  void make(const OsmItem& item, SourceFeature& feature) {
    feature.geometry.clear();
    feature.warnings.clear();
    feature.broken.clear();
    feature.fid = id_of(item);
    switch (item.form) {
      case Form::kPoint:
        return make_point(data_.nodes[item.index], feature);
      case Form::kLine:
      case Form::kPassage:
        return make_line(data_.ways[item.index], feature);
      case Form::kPolygon:
        return make_polygon(data_.ways[item.index], feature);
      case Form::kMultipolygon:
        return make_multipolygon(data_.relations[item.index], feature);
      case Form::kRelation:
        return make_relation(data_.relations[item.index], feature);
      case Form::kWalls:
        return make_walls(data_.ways[item.index], feature);
    }
  }

 private:
  std::int64_t id_of(const OsmItem& item) const {
    if (item.form == Form::kPoint) return data_.nodes[item.index].id;
    const bool relation = item.form == Form::kMultipolygon || item.form == Form::kRelation;
    return relation ? data_.relations[item.index].id : data_.ways[item.index].id;
  }

  static void add_edges(const OsmWay& way, std::set<NodePair>& edges) {
    for (std::size_t i = 0; i + 1 < way.nodes.size(); ++i) {
      edges.insert(unordered(way.nodes[i], way.nodes[i + 1]));
    }
  }

  static void append(Point place, SourceGeometry& geometry) {
    geometry.xs.push_back(place.x);
    geometry.ys.push_back(place.y);
  }

  void make_point(const OsmNode& node, SourceFeature& feature) const {
    feature.geometry.type = "POINT";
    feature.geometry.paths.push_back({0, 1, PathRole::kPoint, false});
    append(*data_.places.find(node.id), feature.geometry);
  }

  // Appends the stretches of a way of which the nodes are there and `keep` holds for the edges.
  template <class Keep>
  void append_stretches(const OsmWay& way, const Keep& keep, SourceGeometry& geometry) const {
    SourcePath path{static_cast<std::uint32_t>(geometry.xs.size()), 0, PathRole::kLine, false};
    const auto end_path = [&] {
      if (path.count > 1) geometry.paths.push_back(path);
      if (path.count == 1) geometry.xs.pop_back(), geometry.ys.pop_back();
      path = {static_cast<std::uint32_t>(geometry.xs.size()), 0, PathRole::kLine, false};
    };
    for (std::size_t i = 0; i < way.nodes.size(); ++i) {
      if (i > 0 && !keep(way.nodes[i - 1], way.nodes[i])) end_path();
      const auto place = data_.places.find(way.nodes[i]);
      if (!place) {
        end_path();
        continue;
      }
      append(*place, geometry);
      ++path.count;
    }
    end_path();
  }

  std::size_t missing_nodes(const OsmWay& way) const {
    return static_cast<std::size_t>(
        std::count_if(way.nodes.begin(), way.nodes.end(),
                      [&](std::int64_t node) { return !data_.places.has(node); }));
  }

  static std::string lacks(std::size_t missing, std::size_t all, const char* what) {
    return "the file lacks " + std::to_string(missing) + " of its " + std::to_string(all) + " " +
           what + ": it was cut out of a larger one";
  }

  void make_line(const OsmWay& way, SourceFeature& feature) const {
    feature.geometry.type = "LINESTRING";
    append_stretches(
        way, [](auto, auto) { return true; }, feature.geometry);
    const auto missing = missing_nodes(way);
    if (missing == 0) return;
    auto& text = feature.geometry.paths.empty() ? feature.broken : feature.warnings.emplace_back();
    text = lacks(missing, way.nodes.size(), "nodes");
  }

  void make_polygon(const OsmWay& way, SourceFeature& feature) const {
    feature.geometry.type = "POLYGON";
    if (const auto missing = missing_nodes(way); missing > 0) {
      feature.broken = lacks(missing, way.nodes.size(), "nodes");
      return;
    }
    const auto problem = append_area_of_way(way, data_, feature.geometry);
    if (!problem.empty()) feature.warnings.push_back(problem);
  }

  void make_multipolygon(const OsmRelation& relation, SourceFeature& feature) const {
    feature.geometry.type = "MULTIPOLYGON";
    std::vector<const OsmWay*> ways;
    for (const auto& member : relation.ways) {
      const auto way = way_numbers_.find(member.way);
      if (way != way_numbers_.end()) ways.push_back(&data_.ways[way->second]);
    }
    if (ways.size() < relation.ways.size()) {
      feature.broken = lacks(relation.ways.size() - ways.size(), relation.ways.size(), "ways");
      return;
    }
    std::sort(ways.begin(), ways.end());
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    const auto problem = append_multipolygon(ways, relation, data_, feature.geometry);
    if (problem.empty()) return;
    auto& text = feature.geometry.paths.empty() ? feature.broken : feature.warnings.emplace_back();
    text = problem;
  }

  void make_relation(const OsmRelation& relation, SourceFeature& feature) const {
    const auto* type = data_.tag(relation.tags, "type");
    feature.geometry.type = "RELATION";
    feature.geometry.unsupported = "relation" + (type == nullptr ? "" : " of type " + *type);
  }

  // Walls of an area: its edges, but passages and those another area has already.
  void make_walls(const OsmWay& way, SourceFeature& feature) {
    feature.geometry.type = "MULTILINESTRING";
    const auto is_free = [this](std::int64_t a, std::int64_t b) {
      return taken_.count(unordered(a, b)) == 0;
    };
    append_stretches(way, is_free, feature.geometry);
    add_edges(way, taken_);
    if (const auto missing = missing_nodes(way); missing > 0) {
      feature.warnings.push_back(lacks(missing, way.nodes.size(), "nodes"));
    } else if (feature.geometry.paths.empty()) {
      feature.geometry.unsupported = "area whose walls are all other areas' or passages";
    }
  }

  const OsmData& data_;
  std::set<NodePair> taken_;  // passages, and walls that are made
  std::unordered_map<std::int64_t, std::size_t> way_numbers_;
};

Crs wgs84() {
  auto crs = parse_crs("EPSG:4326");
  return crs ? *crs : Crs{};
}

class OsmReader : public DocumentReader {
 public:
  OsmReader(std::string path, OsmData data)
      : DocumentReader("OSM"),
        path_(std::move(path)),
        data_(std::move(data)),
        sorted_(osm_layers(data_)) {
    const auto crs = wgs84();
    for (const auto& layer : sorted_) {
      LayerInfo info;
      info.name = layer.name;
      info.fields = data_.keys;
      info.geometry = layer.geometry;
      info.crs = crs;
      info.declared_features = static_cast<std::int64_t>(layer.items.size());
      add_layer(std::move(info));
    }
    warn_of_storeys();
  }

 private:
  // By key: whether its values are wanted.
  std::vector<bool> keys_to_read(const ReadOptions* options) const {
    const bool all = options != nullptr && (options->fields.empty() || !options->where.empty());
    std::vector<bool> wanted(data_.keys.size(), all);
    if (all || options == nullptr) return wanted;
    const auto& names = options->fields;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      wanted[i] = std::find(names.begin(), names.end(), data_.keys[i]) != names.end();
    }
    return wanted;
  }

  void each(std::size_t layer, const ReadOptions* options, const FeatureVisitor& visit) override {
    const std::vector<bool> is_wanted = keys_to_read(options);
    SourceFeature feature;
    feature.values.resize(data_.keys.size());
    FeatureMaker maker(data_, sorted_[layer]);
    for (const auto& item : sorted_[layer].items) {
      const auto& tags = tags_of(item, data_);
      for (const auto& [key, value] : tags) {
        if (is_wanted[key]) feature.values[key] = value;
      }
      maker.make(item, feature);
      visit(feature);
      for (const auto& [key, value] : tags) feature.values[key] = std::monostate();
    }
  }

  void warn_of_storeys() {
    const auto is_indoor = [](const OsmLayer& layer) {
      return layer.name.starts_with("osmAG level ");
    };
    const auto first = std::find_if(sorted_.begin(), sorted_.end(), is_indoor);
    if (std::count_if(first, sorted_.end(), is_indoor) < 2) return;
    warn(path_ +
         ": holds several levels of a building, which a map would have one on top of the other: "
         "take one, as with --layer '" +
         first->name + "'");
  }

  std::string path_;
  OsmData data_;
  std::vector<OsmLayer> sorted_;
};

bool ends_with_any(const std::string& path, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return path.ends_with(ending); });
}

}  // namespace

bool is_osm(const std::string& path) {
  if (ends_with_any(path, {".osm", ".osm.gz", ".osm.bz2", ".pbf", ".osc", ".osc.gz"})) return true;
  std::array<char, 512> start{};
  const auto size = StoredFile(path).read(0, start.data(), start.size());
  const std::string_view text(start.data(), size);
  return text.find("<osm ") != text.npos || text.substr(0, 32).find("OSMHeader") != text.npos;
}

OpenedReader open_osm(const std::string& path) {
  if (ends_with_any(path, {".osc", ".osc.gz"})) {
    return input_failure(path + ": is a file of changes: apply them first, and give the result");
  }
  auto data = read_osm(path);
  if (!data) return input_failure(path + ": " + data.error().message);
  auto reader = std::make_unique<OsmReader>(path, *std::move(data));
  if (reader->layers().empty()) return input_failure(path + ": holds no tagged object");
  return reader;
}

}  // namespace mapwright::converter
