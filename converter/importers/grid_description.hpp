// Private to this folder: what a map server's YAML file says of its image.
#pragma once

#include <string>

#include "converter/importers/occupancy_grid.hpp"

namespace mapwright::converter {

struct GridDescription {
  std::string image;
  double resolution_m = 0.0;
  Pose origin;
  bool negate = false;  ///< white is occupied
  bool raw = false;     ///< pixels are percent, above 100 unknown
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;

  /// What a pixel from 0 to 255 stands for.
  Cell cell_of(double pixel) const;
};

/// `name` stands for the file in messages.
Result<GridDescription> parse_grid_description(const std::string& yaml, const std::string& name);

}  // namespace mapwright::converter
