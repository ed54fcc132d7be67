// The segments of one obstacle, found by place.
#pragma once

#include <cstdint>
#include <memory>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"
#include "mapcore/map.hpp"

namespace mapwright::validators {

/// Looks at every segment of a small obstacle, and at few of a large one. Segments of no length are
/// passed over. The obstacle must outlive the finder.
class EdgeFinder {
 public:
  explicit EdgeFinder(const Obstacle& obstacle);

  /// Calls `visit(i)` for each segment whose box meets `box`.
  template <class Visit>
  void visit(const Box& box, const Visit& visit) const {
    if (index_) {
      index_->query(box, [&](std::size_t k) {
        visit((*index_)[k].tag);
        return true;
      });
      return;
    }
    for (std::size_t i = 0; i < obstacle_->segments.size(); ++i) {
      const auto& [a, b] = ends(i);
      if (a != b && meets_box(a, b, box)) visit(static_cast<std::uint32_t>(i));
    }
  }

  /// Where p lies with respect to the ring that the segments form (odd-even rule); exact.
  PointSide side(Point p) const;

  /// Distance from p to the nearest segment.
  double distance_m(Point p) const;

  const Obstacle& obstacle() const { return *obstacle_; }

 private:
  struct Ends {
    Point a, b;
  };
  Ends ends(std::size_t i) const {
    const auto& segment = obstacle_->segments[i];
    return {segment.a, segment.b};
  }
  static bool meets_box(Point a, Point b, const Box& box) {
    return (a.x <= box.max_x || b.x <= box.max_x) && (a.x >= box.min_x || b.x >= box.min_x) &&
           (a.y <= box.max_y || b.y <= box.max_y) && (a.y >= box.min_y || b.y >= box.min_y);
  }

  const Obstacle* obstacle_;
  std::shared_ptr<const SegmentIndex> index_;  // where there are many segments
};

}  // namespace mapwright::validators
