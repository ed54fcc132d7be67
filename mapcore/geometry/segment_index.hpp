// A spatial index over segments.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright {

struct IndexedSegment {
  Point a, b;
  std::uint32_t tag = 0;  ///< the caller's: what the segment belongs to
};

/// Finds segments by place. Immutable once built; safe to query from many threads.
///
/// n log n to build, packed; queries visit what their box or distance needs.
class SegmentIndex {
 public:
  explicit SegmentIndex(std::vector<IndexedSegment> segments);
  SegmentIndex(SegmentIndex&&) noexcept;
  SegmentIndex& operator=(SegmentIndex&&) noexcept;
  ~SegmentIndex();

  std::size_t size() const { return segments_.size(); }
  const IndexedSegment& operator[](std::size_t i) const { return segments_[i]; }

  /// Calls `visit(i)` for every segment whose box meets `box` (closed); in no promised order.
  /// Stops when `visit` returns false; returns false if stopped.
  bool query(const Box& box, const std::function<bool(std::size_t)>& visit) const;

  struct Nearest {
    std::size_t segment = 0;
    double distance_m = 0.0;
    Point at;  ///< the nearest point on it
  };
  /// Nearest segment to p; nothing for an empty index. Of equally near ones any, but always the
  /// same.
  std::optional<Nearest> nearest(Point p) const;

  /// Distance from p to the nearest segment, at most `limit_m`: cheaper than `nearest` where only
  /// a bound matters. Returns `limit_m` where nothing is nearer.
  double clearance_m(Point p, double limit_m) const;

  /// True if some segment has a point in common with the closed segment ab (exact).
  bool meets(Point a, Point b) const;

  /// Calls `visit(i)` for every segment that has a point in common with the closed segment ab
  /// (exact); in no promised order. Stops when `visit` returns false; returns false if stopped.
  bool query_meeting(Point a, Point b, const std::function<bool(std::size_t)>& visit) const;

  /// True if some segment comes nearer than `radius_m` to the closed segment ab.
  bool comes_near(Point a, Point b, double radius_m) const;

 private:
  struct Tree;
  std::vector<IndexedSegment> segments_;
  std::unique_ptr<Tree> tree_;
};

/// Calls `visit(i, j)` once for each pair i < j of boxes that meet (closed) when each is grown by
/// `reach_m` on all sides; n log n + output, linear for boxes of about one size. In no promised
/// order. Empty boxes meet nothing.
void for_each_meeting_pair(std::span<const Box> boxes,
                           const std::function<void(std::size_t, std::size_t)>& visit,
                           double reach_m = 0.0);

}  // namespace mapwright
