// OpenStreetMap files: XML and PBF, plain or compressed, whole extracts and what JOSM saves.
#pragma once

#include <string>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// True for an OSM file, by its name or its first bytes.
bool is_osm(const std::string& path);

/// Opens an OSM file. Its layers (those that hold something):
/// - points: tagged nodes; lines: tagged ways; polygons: tagged closed ways that are areas (by
///   `area`, or by a key such as building or landuse); multipolygons: relations of type
///   multipolygon, put together from their ways;
/// - relations: all other relations, without geometry;
/// - "osmAG", or "osmAG level N" for each level, of osmAG indoor maps: the walls of their areas as
///   lines, each wall once although two rooms share it, with gaps where passages are; and the
///   passages.
///
/// Fields are the tags' keys. Features are numbered as in OSM, with negative ids where JOSM has not
/// uploaded them. Nodes, ways and relations may come in any order.
///
/// A way of which the file lacks nodes is cut there, and a relation of which it lacks ways has no
/// geometry: the features say so. Fails (kInput) for files that are damaged or hold no data.
OpenedReader open_osm(const std::string& path);

}  // namespace mapwright::converter
