// Differences in words, the same in every format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/diff/diff_answer.hpp"

namespace mapwright::cli {

/// "added", "removed", "reshaped", "moved", "changed" (attributes), "renumbered": all that hold,
/// what weighs most first.
std::vector<std::string_view> change_kinds(const ObstacleChange& change);

/// The new obstacle, or the removed one.
const Obstacle& obstacle_of(const DiffAnswer& answer, const ObstacleChange& change);

/// The middle of its box; nothing for an obstacle without segments.
std::optional<Point> place_of(const Obstacle& obstacle);

/// A difference in one line, without a full stop.
struct DiffLine {
  std::string_view kind;  ///< of change_kinds, or border, area, route, scan
  std::string text;
  std::optional<Point> at;
  std::optional<std::size_t> change;  ///< position in MapDiff::changes of what is an obstacle's
};

/// All of them: border, obstacles, areas, routes, and the scan that differs most. Obstacles that
/// were only renumbered have none.
std::vector<DiffLine> diff_lines(const DiffAnswer& answer);

/// "1 added, 0 removed, …".
std::string summary_line(const DiffAnswer& answer);

/// "3 obstacles have another number only"; empty for none.
std::string renumbered_line(const DiffAnswer& answer);

}  // namespace mapwright::cli
