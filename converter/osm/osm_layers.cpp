#include "converter/osm/osm_layers.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>

namespace mapwright::converter {
namespace {

using Form = OsmItem::Form;

// Tags that say where an object comes from and nothing of what it is.
constexpr std::array<std::string_view, 6> kIdleKeys{"created_by", "converted_by", "source",
                                                    "time",       "attribution",  "note"};

// Keys that make a closed way an area (compare osmconf.ini of GDAL and id-tagging-schema's).
constexpr std::array<std::string_view, 27> kAreaKeys{
    "aeroway",        "amenity",    "area:highway", "boundary", "building", "building:part",
    "craft",          "geological", "historic",     "indoor",   "landuse",  "leisure",
    "military",       "natural",    "office",       "place",    "power",    "public_transport",
    "room",           "ruins",      "shop",         "sport",    "tourism",  "ag_area",
    "osmAG:areaType", "healthcare", "parking"};

constexpr std::array<std::string_view, 5> kLineValues{"coastline", "cliff", "tree_row", "ridge",
                                                      "line"};

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& texts, std::string_view text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

class Sorter {
 public:
  explicit Sorter(const OsmData& data) : data_(data), way_numbers_(member_ways(data)) {}

  std::vector<OsmLayer> layers() {
    for (std::size_t i = 0; i < data_.relations.size(); ++i) sort_relation(i);
    for (std::size_t i = 0; i < data_.nodes.size(); ++i) {
      if (says_something(data_.nodes[i].tags)) points_.items.push_back({Form::kPoint, i});
    }
    for (std::size_t i = 0; i < data_.ways.size(); ++i) sort_way(i);
    std::vector<OsmLayer> layers;
    for (auto* layer : {&points_, &lines_, &polygons_, &multipolygons_, &relations_}) {
      if (!layer->items.empty()) layers.push_back(std::move(*layer));
    }
    for (auto& [level, layer] : indoor_) layers.push_back(std::move(layer));
    return layers;
  }

 private:
  bool says_something(const OsmTags& tags) const {
    return std::any_of(tags.begin(), tags.end(), [&](const OsmTag& tag) {
      return !contains(kIdleKeys, data_.keys[tag.first]);
    });
  }

  bool is_area(const OsmWay& way) const {
    if (!way.is_closed() || data_.has(way.tags, "area", "no")) return false;
    if (data_.has(way.tags, "area", "yes")) return true;
    return std::any_of(way.tags.begin(), way.tags.end(), [&](const OsmTag& tag) {
      return contains(kAreaKeys, data_.keys[tag.first]) && !contains(kLineValues, tag.second) &&
             tag.second != "no";
    });
  }

  // The ways that lend a relation without tags of its own theirs are no features themselves.
  void sort_relation(std::size_t index) {
    const auto& relation = data_.relations[index];
    if (!data_.has(relation.tags, "type", "multipolygon")) {
      return relations_.items.push_back({Form::kRelation, index});
    }
    auto& item = multipolygons_.items.emplace_back(OsmItem{Form::kMultipolygon, index});
    if (relation.tags.size() > 1) return;
    for (const auto& member : relation.ways) {
      const auto way = way_numbers_.find(member.way);
      if (member.role == "inner" || way == way_numbers_.end()) continue;
      lenders_.insert(way->second);
      if (!item.lender && says_something(data_.ways[way->second].tags)) item.lender = way->second;
    }
  }

  void sort_way(std::size_t index) {
    const auto& way = data_.ways[index];
    if (!says_something(way.tags) || lenders_.count(index) > 0) return;
    const auto* indoor_type = data_.tag(way.tags, "osmAG:type");
    const bool passage = indoor_type != nullptr && *indoor_type == "passage";
    const bool area = (indoor_type != nullptr && *indoor_type == "area") ||
                      data_.tag(way.tags, "ag_area") != nullptr;
    if (passage) return indoor_layer(way).items.push_back({Form::kPassage, index});
    if (area) return indoor_layer(way).items.push_back({Form::kWalls, index});
    if (is_area(way)) return polygons_.items.push_back({Form::kPolygon, index});
    lines_.items.push_back({Form::kLine, index});
  }

  OsmLayer& indoor_layer(const OsmWay& way) {
    const auto* level = data_.tag(way.tags, "level");
    auto& layer = indoor_[level == nullptr ? std::string() : *level];
    layer.name = level == nullptr ? "osmAG" : "osmAG level " + *level;
    layer.geometry = GeometryKind::kLine;
    return layer;
  }

  const OsmData& data_;
  std::unordered_map<std::int64_t, std::size_t> way_numbers_;
  std::set<std::size_t> lenders_;
  OsmLayer points_{"points", GeometryKind::kPoint, {}};
  OsmLayer lines_{"lines", GeometryKind::kLine, {}};
  OsmLayer polygons_{"polygons", GeometryKind::kPolygon, {}};
  OsmLayer multipolygons_{"multipolygons", GeometryKind::kPolygon, {}};
  OsmLayer relations_{"relations", GeometryKind::kNone, {}};
  std::map<std::string, OsmLayer> indoor_;  // by level
};

}  // namespace

std::vector<OsmLayer> osm_layers(const OsmData& data) {
  return Sorter(data).layers();
}

const OsmTags& tags_of(const OsmItem& item, const OsmData& data) {
  switch (item.form) {
    case Form::kPoint:
      return data.nodes[item.index].tags;
    case Form::kMultipolygon:
    case Form::kRelation:
      return item.lender ? data.ways[*item.lender].tags : data.relations[item.index].tags;
    default:
      return data.ways[item.index].tags;
  }
}

}  // namespace mapwright::converter
