// Private to this folder: what GDAL does not tell of a DXF file's entities.
#pragma once

#include <string>
#include <vector>

namespace mapwright::converter {

/// An entity of a drawing of which GDAL reads nothing, or not all.
struct UnreadEntity {
  std::string layer;
  std::string why;  ///< what is lost, and what to do in the program that draws
};

struct UnreadEntities {
  std::vector<UnreadEntity> lost;        ///< in the drawing's order
  std::vector<std::string> passed_over;  ///< kinds that show nothing a robot can meet: "2 WIPEOUT"
};

/// Looks at the entities of model space, and into the blocks they insert.
UnreadEntities unread_dxf_entities(const std::string& path);

}  // namespace mapwright::converter
