// A flight of stairs as the report draws it: steps of growing or falling height and a closing
// segment.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// The segments of an obstacle of shape type 5, sorted into steps and closing segments. Segments of
/// no length are left out (G103 tells of them).
struct Flight {
  std::vector<std::size_t> steps;    ///< segments higher than 0, as they are printed
  std::vector<std::size_t> closing;  ///< segments of height 0, as they are printed
  bool rises = true;                 ///< most steps are higher than the one printed before them
  std::optional<std::size_t> top;    ///< the closing segment beside the highest step
  /// Per step: true if it faces as most steps do, each compared with the step before it.
  std::vector<bool> faces_as_most;
};

/// Both orders are understood: from the foot up with the closing segment last (the report's prose),
/// and from the top down with the closing segment first (its printed sample).
Flight flight_of(const Obstacle& stairs);

}  // namespace mapwright::validators
