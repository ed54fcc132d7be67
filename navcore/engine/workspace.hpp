// Private to this folder: what a thread needs to cast scans.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/engine/aligned.hpp"
#include "navcore/engine/packed_cell.hpp"

namespace mapwright::navcore::engine {

/// Spans on their way into buffers of inverse ranges: 1/r = cosine · cos φ + sine · sin φ for some
/// rays. Whole vectors of them, of which some have no rays and `seen` says which have; or (AVX-512)
/// those that have rays only.
class SpanList {
 public:
  void clear() { size = lanes = 0; }

  /// Makes room for so many more lanes.
  void make_room(std::size_t more) {
    const std::size_t needed = std::max(size, lanes) + more + kBlock;
    if (needed <= cosine.size()) return;
    for (AlignedFloats* array : {&cosine, &sine}) array->resize(2 * needed);
    for (AlignedInts* array : {&ray, &which, &end, &at, &seen, &longer}) array->resize(2 * needed);
  }

  std::size_t size = 0;   ///< spans
  std::size_t lanes = 0;  ///< of whole vectors
  AlignedFloats cosine, sine;
  AlignedInts ray;     ///< where the vector of rays begins that the first ray is in
  AlignedInts which;   ///< the first ray, or (AVX-512) bit i: ray + i belongs to the span
  AlignedInts end;     ///< one beyond the last ray
  AlignedInts at;      ///< place of `ray` in the buffers
  AlignedInts seen;    ///< lanes that have rays
  AlignedInts longer;  ///< scratch: those with more rays than are done at once
};

/// One of the starts.
struct StartInCell {
  const PackedCell* cell;
  std::uint32_t start;
};

/// A segment whose line runs through a laser, nearly: for double precision.
struct TouchedItem {
  StartInCell scan;
  std::uint32_t lane;  ///< of the cell's list
  std::int32_t row;    ///< place of the buffer that it belongs to
};

/// A staircase of which a scan sees steps that stop rays.
struct StairsView {
  std::size_t scan;         ///< position among those cast together
  std::size_t row;          ///< of three rows: tops, low steps, stops
  std::int32_t first, end;  ///< vectors of rays that meet stops
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
  std::vector<StartInCell> alone;  ///< scans that share their cell with too few others

 private:
  std::size_t padded_rays_;
};

}  // namespace mapwright::navcore::engine
