// Private to this folder: what a thread needs to cast scans.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/engine/aligned.hpp"
#include "navcore/engine/candidates.hpp"
#include "navcore/engine/packed_cell.hpp"
#include "navcore/engine/span_list.hpp"

namespace mapwright::navcore::engine {

/// One of the starts.
struct StartInCell {
  const PackedCell* cell;
  std::uint32_t start;
};

/// A segment whose line runs through a laser, nearly: for double precision.
struct TouchedItem {
  StartInCell scan;
  std::uint32_t segment;  ///< of the cell's list
  std::int32_t row;       ///< place of the buffer that it belongs to
};

/// More than rays have numbers.
inline constexpr std::int32_t kNoRay = INT32_MAX;

/// A staircase of which a scan sees steps that stop rays.
struct StairsView {
  std::size_t scan;         ///< position among those cast together
  std::size_t row;          ///< of three rows: tops, low steps, stops
  std::int32_t first, end;  ///< rays that meet stops, and those between

  void add(std::int32_t more_first, std::int32_t more_end) {
    first = std::min(first, more_first);
    end = std::max(end, more_end);
  }
};

/// Memory of one thread.
class Workspace {
 public:
  explicit Workspace(std::size_t padded_rays)
      : inverses(kBlock * padded_rays), padded_rays_(padded_rays) {
    for (std::size_t i = 0; i < kBlock; ++i) {
      rows.push_back(row(i));
      stairs_rows.push_back(row(3 * i));
    }
  }

  /// Place in the buffers of the i-th of up to a block of scans, or of the i-th part of a
  /// staircase.
  std::int32_t row(std::size_t i) const { return static_cast<std::int32_t>(i * padded_rays_); }

  /// Forgets what is listed.
  void clear() {
    walls.clear();
    steps.clear();
    touched_walls.clear();
    touched_steps.clear();
    stairs_views.clear();
  }

  /// Makes room for so many rows of staircases.
  void make_stairs_rows(std::size_t count) {
    if (count * padded_rays_ > stairs.size()) stairs.resize(2 * count * padded_rays_);
  }

  /// Inverse ranges (1/m) of the i-th scan.
  float* inverse(std::size_t i) { return inverses.data() + row(i); }

  AlignedFloats inverses;   ///< of some scans, row by row
  AlignedFloats stairs;     ///< of tops, low steps and stops, row by row
  AlignedInts rows;         ///< row(0), row(1), …
  AlignedInts stairs_rows;  ///< row(0), row(3), …
  SpanList walls;           ///< and ramps, for the rows of `inverses`
  SpanList steps;           ///< and tops, for the rows of `stairs`
  std::vector<TouchedItem> touched_walls, touched_steps;  ///< rarely any
  std::vector<StairsView> stairs_views;
  LaserTable lasers, stairs_lasers;
  Candidates candidates;
  std::vector<StartInCell> alone;  ///< scans that share their cell with too few others

 private:
  std::size_t padded_rays_;
};

}  // namespace mapwright::navcore::engine
