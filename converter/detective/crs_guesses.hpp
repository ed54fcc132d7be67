// What the coordinates of a drawing may be, where nobody says.
#pragma once

#include <string>
#include <vector>

#include "converter/detective/evidence.hpp"
#include "converter/gdal/crs.hpp"

namespace mapwright::converter {

/// A layer that states its CRS, beside the one that does not.
struct Neighbour {
  std::string name;  ///< for messages: "buildings.shp"
  Crs crs;
  Box extent;  ///< in its CRS
};

/// One explanation of a drawing's numbers.
struct CrsGuess {
  std::string what;     ///< "longitude and latitude (EPSG:4326)"
  std::string because;  ///< the arguments, in one clause
  std::string remedy;   ///< "--source-crs EPSG:4326"
  double weight = 0.0;  ///< higher is likelier; only the order means something
};

/// Explanations that fit the evidence, the likeliest first; at most `most`.
std::vector<CrsGuess> guess_crs(const DrawingEvidence& evidence,
                                const std::vector<Neighbour>& neighbours, std::size_t most = 5);

/// The guesses as numbered lines under a message that refuses a drawing; empty where there is none.
std::string guesses_text(const DrawingEvidence& evidence, const std::vector<CrsGuess>& guesses);

}  // namespace mapwright::converter
