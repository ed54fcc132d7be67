// Private to this folder: which objects of an OSM file are features of which layer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/osm/osm_data.hpp"
#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// One feature to be: an object of OsmData and what shall become of it.
struct OsmItem {
  enum class Form { kPoint, kLine, kPolygon, kMultipolygon, kRelation, kWalls, kPassage };
  Form form = Form::kPoint;
  std::size_t index = 0;                ///< in OsmData::nodes, ways or relations
  std::optional<std::size_t> lender{};  ///< the way that lends a multipolygon its tags
};

struct OsmLayer {
  std::string name;
  GeometryKind geometry = GeometryKind::kMixed;
  std::vector<OsmItem> items;
};

/// The layers that hold something.
std::vector<OsmLayer> osm_layers(const OsmData& data);

/// Tags of a feature. A multipolygon without tags of its own has those of its outer ways, as was
/// the custom once.
const OsmTags& tags_of(const OsmItem& item, const OsmData& data);

}  // namespace mapwright::converter
