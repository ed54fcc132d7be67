// Private to this folder: what a thread needs to cast scans.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/engine/aligned.hpp"
#include "navcore/engine/candidates.hpp"
#include "navcore/engine/scan_starts.hpp"
#include "navcore/engine/span_list.hpp"

namespace mapwright::navcore::engine {

/// A segment whose line runs through a laser, nearly: for double precision.
struct TouchedItem {
  StartInCell scan;
  std::uint32_t segment;  ///< of the cell's list
  std::int32_t row;       ///< place of the buffer that it belongs to
};

/// What scans meet.
struct FoundSpans {
  void clear() {
    spans.clear();
    touched.clear();
  }
  bool empty() const { return spans.seen.size == 0 && touched.empty(); }

  SpanList spans;
  std::vector<TouchedItem> touched;  ///< rarely any
};

/// A staircase that needs rows of its own.
struct StairsView {
  std::size_t scan;  ///< position among those cast together
  std::size_t row;   ///< of three rows: tops, low steps, stops
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
    for (FoundSpans* found : {&walls, &lone_stops, &lone_tops, &steps}) found->clear();
    stairs_views.clear();
  }

  /// Makes room for so many rows of staircases.
  void make_stairs_rows(std::size_t count) {
    if (count * padded_rays_ > stairs.size()) stairs.resize(2 * count * padded_rays_);
  }

  /// Inverse ranges (1/m) of the i-th scan.
  float* inverse(std::size_t i) { return inverses.data() + row(i); }

  AlignedFloats inverses;            ///< of some scans, row by row
  AlignedFloats stairs;              ///< of tops, low steps and stops, row by row
  AlignedInts rows;                  ///< row(0), row(1), …
  AlignedInts stairs_rows;           ///< row(0), row(3), …
  FoundSpans walls;                  ///< and ramps, for the rows of `inverses`
  FoundSpans lone_stops, lone_tops;  ///< of lone staircases, for the rows of `inverses`
  FoundSpans steps;                  ///< and tops of others, for the rows of `stairs`
  std::vector<StairsView> stairs_views;
  Candidates candidates;
  std::vector<std::uint16_t> marks;  ///< of the cells that a piece visits

 private:
  std::size_t padded_rays_;
};

}  // namespace mapwright::navcore::engine
