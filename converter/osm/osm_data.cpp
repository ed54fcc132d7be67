#include "converter/osm/osm_data.hpp"

#include <exception>
#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/gzip_compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm.hpp>
#include <unordered_set>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

OsmTags tags_of(const osmium::TagList& from, OsmData& data) {
  OsmTags tags;
  tags.reserve(from.size());
  for (const auto& tag : from) tags.emplace_back(data.key(tag.key()), tag.value());
  return tags;
}

void add_node(const osmium::Node& from, OsmData& data) {
  if (!from.location().valid()) return;
  data.places.add(from.id(), {from.location().x(), from.location().y()});
  if (!from.tags().empty()) data.nodes.push_back({from.id(), tags_of(from.tags(), data)});
}

void add_way(const osmium::Way& from, OsmData& data) {
  OsmWay way{from.id(), {}, tags_of(from.tags(), data)};
  way.nodes.reserve(from.nodes().size());
  for (const auto& node : from.nodes()) {
    way.nodes.push_back(node.ref());
    if (!node.location().valid()) continue;  // Overpass writes places of nodes into the ways
    data.places.add_of_way(node.ref(), {node.location().x(), node.location().y()});
  }
  data.ways.push_back(std::move(way));
}

void add_relation(const osmium::Relation& from, OsmData& data) {
  OsmRelation relation{from.id(), {}, 0, tags_of(from.tags(), data)};
  for (const auto& member : from.members()) {
    if (member.type() == osmium::item_type::way)
      relation.ways.push_back({member.ref(), member.role()});
    else
      ++relation.other_members;
  }
  data.relations.push_back(std::move(relation));
}

void add(const osmium::OSMObject& object, OsmData& data) {
  if (!object.visible()) return;
  switch (object.type()) {
    case osmium::item_type::node:
      return add_node(static_cast<const osmium::Node&>(object), data);
    case osmium::item_type::way:
      return add_way(static_cast<const osmium::Way&>(object), data);
    case osmium::item_type::relation:
      return add_relation(static_cast<const osmium::Relation&>(object), data);
    default:
      return;
  }
}

// Osmium reads disks and memory, and not GDAL's virtual files.
osmium::io::File file_of(const std::string& path, std::string& unpacked) {
  if (!path.starts_with("/vsimem/")) return osmium::io::File{path};
  unpacked = stored_content(path).value_or("");
  const auto format = path.ends_with(".pbf")       ? "pbf"
                      : path.ends_with(".osm.gz")  ? "osm.gz"
                      : path.ends_with(".osm.bz2") ? "osm.bz2"
                                                   : "osm";
  return osmium::io::File{unpacked.data(), unpacked.size(), format};
}

}  // namespace

std::uint32_t OsmData::key(const std::string& name) {
  const auto [found, is_new] =
      key_numbers_.try_emplace(name, static_cast<std::uint32_t>(keys.size()));
  if (is_new) keys.push_back(name);
  return found->second;
}

const std::string* OsmData::tag(const OsmTags& tags, const std::string& key) const {
  const auto number = key_numbers_.find(key);
  if (number == key_numbers_.end()) return nullptr;
  for (const auto& [own, value] : tags) {
    if (own == number->second) return &value;
  }
  return nullptr;
}

bool OsmData::has(const OsmTags& tags, const std::string& key, const std::string& value) const {
  const auto* found = tag(tags, key);
  return found != nullptr && *found == value;
}

std::unordered_map<std::int64_t, std::size_t> member_ways(const OsmData& data) {
  std::unordered_set<std::int64_t> members;
  for (const auto& relation : data.relations) {
    for (const auto& member : relation.ways) members.insert(member.way);
  }
  std::unordered_map<std::int64_t, std::size_t> positions;
  for (std::size_t i = 0; i < data.ways.size(); ++i) {
    if (members.count(data.ways[i].id) > 0) positions.emplace(data.ways[i].id, i);
  }
  return positions;
}

Result<OsmData> read_osm(const std::string& path) {
  OsmData data;
  std::string unpacked;  // outlives the reader
  try {
    osmium::io::Reader reader(file_of(path, unpacked), osmium::osm_entity_bits::nwr);
    while (const auto buffer = reader.read()) {
      for (const auto& object : buffer.select<osmium::OSMObject>()) add(object, data);
    }
    reader.close();
    data.places.finish();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return input_failure(std::string("the OSM file is damaged: ") + error.what());
  }
  return data;
}

}  // namespace mapwright::converter
