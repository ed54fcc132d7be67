// Private to this folder: what a cut part remembers of the obstacles that were cut.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright {

/// Obstacles as they were before they were cut: an outline and its holes, or one obstacle.
struct CutRecord {
  double resolution_m = 0.0;  ///< at which they were cut
  std::vector<Obstacle> family;

  friend bool operator==(const CutRecord&, const CutRecord&) = default;
};

/// The value of the token `cut`: records between slashes, fields between colons. The first is the
/// resolution; one of three fields begins an obstacle (id, ST, semantic), others are its segments:
/// the end, or both ends where it does not begin where the one before ended, and height, inOut and
/// semantic where they are not those of the one before. Numbers have the fewest digits that read
/// back the same; bytes with a meaning in maps or here are written %XX.
std::string format_cut_record(double resolution_m, std::span<const Obstacle* const> family);

/// Reads what `format_cut_record` wrote; nothing for anything else.
std::optional<CutRecord> parse_cut_record(std::string_view text);

}  // namespace mapwright
