// IndoorGML: rooms of buildings, storey by storey.
#pragma once

#include <string>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// True for a GML document that begins as IndoorGML.
bool is_indoorgml(const std::string& path);

/// Opens an IndoorGML document. Its layers:
/// - "IndoorGML", or "IndoorGML storey N" for each of several storeys: cells of the space (all
///   CellSpaces and what extends them), then the boundaries of cells. Of a cell that one can be in,
///   the walls around its floor are the geometry, as lines with the cell on their right: each wall
///   once although two cells share it, with gaps where a boundary is an opening, and where a cell
///   that is a door adjoins. A cell that cannot be entered is a polygon.
/// - "IndoorGML graph": states and transitions, as points and lines.
///
/// Fields: gml_id, type, name, description, storey, class, function, usage; role (room, object,
/// wall, opening or graph); height (of a solid) and base_height (of its floor above the storey's),
/// metres. Features are numbered from 1 as they come in the document.
OpenedReader open_indoorgml(const std::string& path);

}  // namespace mapwright::converter
