// Private to this folder: areas of multipolygon relations.
#pragma once

#include <string>
#include <vector>

#include "converter/osm/osm_data.hpp"
#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// Puts a multipolygon together from the ways of its relation and appends its rings to `geometry`.
/// Ways are those the file holds.
///
/// Stretches that two rings share, or that one walks twice, are no edges of the area (as OSM has
/// it): that is no problem. Rings that cross or overlap cannot be told apart: they are all appended
/// as rings of one polygon, if they close, for whoever repairs polygons. The answer is empty for a
/// sound multipolygon, and else says what is wrong with it, also where the rings could be found all
/// the same (roles that contradict them, members that come twice, spikes, two nodes at one
/// place).
std::string append_multipolygon(const std::vector<const OsmWay*>& ways, const OsmRelation& relation,
                                const OsmData& data, SourceGeometry& geometry);

/// The same for a closed way that is an area. A way that visits no node twice is its own outline.
std::string append_area_of_way(const OsmWay& way, const OsmData& data, SourceGeometry& geometry);

}  // namespace mapwright::converter
