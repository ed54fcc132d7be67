// Private to this folder: where the nodes of an OSM file lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// Places by node id, in 16 bytes a node: a sorted array, because most nodes are nothing but
/// corners of ways and there are many. Coordinates are OSM's own, ten millionths of a degree.
class OsmPlaces {
 public:
  struct Place {
    std::int32_t x = 0, y = 0;  ///< longitude and latitude
  };

  /// A node; of several with one id the last counts.
  void add(std::int64_t node, Place place) { nodes_.push_back({node, place}); }
  /// What a way says of its node (Overpass): the first to say it counts, if no node does.
  void add_of_way(std::int64_t node, Place place) { of_ways_.push_back({node, place}); }
  /// To be called once, when all are added and before any is asked for.
  void finish();

  bool has(std::int64_t node) const { return entry_of(node) != nullptr; }
  /// x = longitude, y = latitude, degrees; nothing where the file does not say.
  std::optional<Point> find(std::int64_t node) const;

 private:
  struct Entry {
    std::int64_t node = 0;
    Place place;
  };
  const Entry* entry_of(std::int64_t node) const;
  void sort();

  std::vector<Entry> nodes_, of_ways_;
  std::vector<std::int64_t> first_of_blocks_;  // small enough to stay in the cache
};

}  // namespace mapwright::converter
