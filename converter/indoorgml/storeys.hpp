// Private to this folder: which floor of the building each cell and boundary stands on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/indoorgml/footprint.hpp"
#include "converter/indoorgml/indoor_document.hpp"

namespace mapwright::converter {

struct Storey {
  std::string name;  ///< as the document calls it, or "0 m" by the height of its floor
  std::optional<double> floor;
  std::vector<std::size_t> cells, boundaries;  ///< positions in the document, ascending
};

/// Storeys from below where they are told by heights, else by name. A cell stands on the storey it
/// names; where it names several ("1-2"), on the first. Cells that name none go by the heights of
/// their floors: 2 m above the lowest of a storey another begins. A boundary belongs to the storey
/// it names, else to that of a cell that names it, else to the one its foot is on.
std::vector<Storey> storeys_of(const IndoorDocument& document,
                               const std::vector<std::optional<Footprint>>& footprints);

/// Lowest z of an object's faces and lines; nothing where it has no heights.
std::optional<double> foot_of(const IndoorObject& object);

}  // namespace mapwright::converter
