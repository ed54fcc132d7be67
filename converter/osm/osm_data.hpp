// Private to this folder: the content of an OSM file as plain values.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "converter/osm/osm_places.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// Position of the key in OsmData::keys, and the value.
using OsmTag = std::pair<std::uint32_t, std::string>;
using OsmTags = std::vector<OsmTag>;

struct OsmNode {
  std::int64_t id = 0;
  OsmTags tags;
};

struct OsmWay {
  std::int64_t id = 0;
  std::vector<std::int64_t> nodes;
  OsmTags tags;

  bool is_closed() const { return nodes.size() > 3 && nodes.front() == nodes.back(); }
};

struct OsmMember {
  std::int64_t way = 0;
  std::string role;
};

struct OsmRelation {
  std::int64_t id = 0;
  std::vector<OsmMember> ways;
  std::size_t other_members = 0;
  OsmTags tags;
};

class OsmData {
 public:
  std::vector<std::string> keys;
  std::vector<OsmNode> nodes;  ///< tagged ones
  std::vector<OsmWay> ways;
  std::vector<OsmRelation> relations;
  OsmPlaces places;

  std::uint32_t key(const std::string& name);
  /// The value of a tag; null where there is none.
  const std::string* tag(const OsmTags& tags, const std::string& key) const;
  bool has(const OsmTags& tags, const std::string& key, const std::string& value) const;

 private:
  std::unordered_map<std::string, std::uint32_t> key_numbers_;
};

/// Positions in OsmData::ways by id, of ways that relations have as members. Of several ways with
/// one id the first counts.
std::unordered_map<std::int64_t, std::size_t> member_ways(const OsmData& data);

/// Reads a file. Fails (kInput) with what is wrong; the message does not name the file.
Result<OsmData> read_osm(const std::string& path);

}  // namespace mapwright::converter
