// What changed from one map to another, in terms of obstacles.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright {

struct MapDiffOptions {
  /// Coordinates and heights that differ by no more are the same (metres).
  double tolerance_m = tolerance::kSamePlace_m;

  /// An obstacle whose id changed too is the same one only if it moved no farther (metres, > 0).
  double longest_move_m = 10.0;
};

/// A value that is not what it was, of the obstacle or of segments of it.
struct AttributeChange {
  std::string field;  ///< shape_type, semantic, height_m, in_out, segment_semantic
  std::string before, after;
  /// 1-based, in the new obstacle; empty for what the obstacle has, and for segments that cannot be
  /// told apart because there are more of them, or fewer.
  std::vector<std::size_t> segments;

  friend bool operator==(const AttributeChange&, const AttributeChange&) = default;
};

/// An obstacle that is not what it was. Positions are those in Map::obstacles.
struct ObstacleChange {
  std::optional<std::size_t> before;  ///< nothing: it was added
  std::optional<std::size_t> after;   ///< nothing: it was removed

  bool moved = false;     ///< the same shape elsewhere
  Point offset;           ///< from the old place to the new one, of what moved
  bool reshaped = false;  ///< another shape
  bool reversed = false;  ///< of what is reshaped: the same lines, drawn the other way round
  /// Of what is reshaped: the farthest any vertex of the one is from the lines of the other.
  double deviation_m = 0.0;
  std::vector<AttributeChange> attributes;
  bool renumbered = false;

  bool added() const { return !before; }
  bool removed() const { return !after; }
  /// True for more than another number.
  bool is_difference() const {
    return added() || removed() || moved || reshaped || !attributes.empty();
  }
};

/// How many obstacles were … ; one that moved and has another height counts as both.
struct MapDiffCounts {
  std::size_t added = 0, removed = 0, moved = 0, reshaped = 0, reattributed = 0, renumbered = 0;
  std::size_t unchanged = 0;  ///< but for their number, perhaps
};

struct MapDiff {
  std::optional<Border> border_before, border_after;  ///< both, where they differ
  /// Removed and changed ones in the order of the old map, then added ones in that of the new.
  /// Includes obstacles of which the id alone changed.
  std::vector<ObstacleChange> changes;
  MapDiffCounts counts;

  /// True if nothing but numbers of obstacles differs.
  bool same() const;
};

/// Matches obstacles by shape, whatever their ids and order, then by id, then by nearness, and
/// compares what was matched (docs/diff.md). A ring may begin at another vertex; `inner_of` follows
/// the ids. Cost grows as n log n unless thousands of changed obstacles crowd within
/// `longest_move_m`. The same maps give the same answer everywhere.
MapDiff diff_maps(const Map& before, const Map& after, const MapDiffOptions& options = {});

}  // namespace mapwright
