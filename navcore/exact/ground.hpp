// Private to this folder: What a map is for a point robot, whatever else drives on it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
#include "mapcore/result.hpp"
#include "navcore/exact/tessellation.hpp"
#include "navcore/exact/widths.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore::exact {

/// The same for robots of all radii, and shared by their planners. Immutable but for what is made
/// when first asked for; safe to use from many threads.
class Ground {
 public:
  /// Failures: a border without area or with numbers that are not finite, an obstacle more than
  /// 500 km from the border's centre.
  static Result<std::shared_ptr<const Ground>> build(const Map& map, RampPolicy ramps);

  Border border;
  GridFrame frame;
  std::vector<BlockingSegment> segments;  ///< by source of the lines
  double snapping_mm = 0.0;               ///< how far a wall may have been moved
  Point snapped_at;                       ///< where, metres; if snapping_mm > 0
  std::shared_ptr<const Tessellation> space;

  const Widths& widths() const;

  /// Of `segments`, in metres as the map has them.
  const SegmentIndex& index() const;

  bool can_ask(Point p) const { return is_finite(p) && border.contains(p); }

 private:
  mutable std::once_flag widths_built_, index_built_;
  mutable std::optional<Widths> widths_;
  mutable std::optional<SegmentIndex> index_;
};

}  // namespace mapwright::navcore::exact
