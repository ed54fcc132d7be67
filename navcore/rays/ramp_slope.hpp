// What a horizontal ray meets of a ramp.
#pragma once

#include <optional>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::navcore {

/// The part of a ramp at one height: pieces of a straight line, where the surface stands as high as
/// the laser.
struct RampContour {
  struct Piece {
    double from, to;  ///< positions along RampSlope::along(), from <= to
  };
  double height_m = 0.0;
  std::vector<Piece> pieces;
};

/// A ramp as rays see it: a surface that stops those who run into it where it rises to their
/// height (docs/rays.md). To a laser at one height the ramp is a wall along the contour of that
/// height, seen from the low side only.
class RampSlope {
 public:
  /// Nothing for an obstacle whose surface normal is missing or does not point up, for one without
  /// segments, and for a level surface: none of these stops a ray.
  static std::optional<RampSlope> of(const Obstacle& ramp);

  RampContour contour(double height_m) const;

  /// Distance at which a ray (unit direction) meets the contour uphill; infinity where it does not.
  double distance_m(const RampContour& contour, Point origin, Point direction) const;

  /// Unit vector along the contours.
  Point along() const { return along_; }

 private:
  RampSlope(const RampPlane& plane, std::vector<Point> footprint);

  RampPlane plane_;
  std::vector<Point> footprint_;
  Point along_;
};

}  // namespace mapwright::navcore
