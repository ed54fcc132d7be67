// The robot map: the report's environment model as value types.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/point.hpp"
#include "mapcore/semantic.hpp"

namespace mapwright {

/// ST of report Eq. (2).
enum class ShapeType : std::uint8_t {
  kClosedPolygon = 1,
  kOpenPolygon = 2,
  kClosedCurve = 3,
  kOpenCurve = 4,
  kStairs = 5,
  kRamp = 6,
};

constexpr bool is_shape_type(std::int64_t number) { return number >= 1 && number <= 6; }

/// True for shapes whose chain of segments ends where it began: polygons, curves, ramp footprints.
constexpr bool is_closed(ShapeType type) {
  return type == ShapeType::kClosedPolygon || type == ShapeType::kClosedCurve ||
         type == ShapeType::kRamp;
}

constexpr bool is_open_chain(ShapeType type) {
  return type == ShapeType::kOpenPolygon || type == ShapeType::kOpenCurve;
}

/// inOut of report Eq. (3).
enum class InOut : std::uint8_t { kIndoor = 0, kOutdoor = 1 };

/// s of report Eq. (3). Oriented: free space lies on the right of a→b.
struct Segment {
  Point a, b;
  double height_m = 0.0;  ///< above the ground beside it; 0 for ramps and the top of stairs
  InOut in_out = InOut::kOutdoor;
  Semantic semantic;

  friend bool operator==(const Segment&, const Segment&) = default;
};

/// o of report Eq. (2).
struct Obstacle {
  std::int64_t id = 0;
  ShapeType shape_type = ShapeType::kClosedPolygon;
  Semantic semantic;
  std::vector<Segment> segments;

  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// Limits of the map, report Eq. (1): (mx1, my1) is the top-left corner, (mx4, my4) the
/// bottom-right one, so left < right and top > bottom in a map that is fit for use.
struct Border {
  double left = 0.0;    ///< mx1
  double top = 0.0;     ///< my1
  double right = 0.0;   ///< mx4
  double bottom = 0.0;  ///< my4

  constexpr Box box() const { return {left, bottom, right, top}; }
  constexpr bool contains(Point p) const { return box().contains(p); }
  constexpr double area_m2() const { return (right - left) * (top - bottom); }
  friend bool operator==(const Border&, const Border&) = default;
};

/// M of report Eq. (1): metres, in a frame of its own (mapcore/georeference.hpp ties it to the
/// Earth).
struct Map {
  Border border;
  std::vector<Obstacle> obstacles;

  friend bool operator==(const Map&, const Map&) = default;
};

/// Segments of all obstacles.
std::size_t segment_count(const Map& map);

/// The start points of the segments, in order; for a chain that is not closed also the last end.
/// A closed ring of n segments gives n points. Empty for no segments.
std::vector<Point> chain_points(const Obstacle& obstacle);

/// Smallest box around all segments of the map; `kEmptyBox` where there is none.
Box extent(const Map& map);
Box extent(const Obstacle& obstacle);

/// Greatest height of the obstacle's segments; 0 where it has none.
double max_height_m(const Obstacle& obstacle);

/// A surface normal: unit length, z up.
struct Normal {
  double x = 0.0, y = 0.0, z = 1.0;
  friend bool operator==(const Normal&, const Normal&) = default;
};

/// The three numbers of the token `normal=nx:ny:nz` of a ramp (docs/format.md), as written: neither
/// their length nor their sign is checked. Nothing where the token is missing or is not three
/// finite numbers.
std::optional<Normal> ramp_normal(const Obstacle& ramp);

/// The value that `ramp_normal` reads back: shortest decimals that keep 1e-9.
std::string format_normal(const Normal& normal);

/// Height of a ramp's plane above its foot. The plane has the ramp's normal and touches height 0 at
/// the lowest vertex of the footprint.
class RampPlane {
 public:
  /// Requires normal.z > 0 and a non-empty footprint.
  RampPlane(const Normal& normal, const std::vector<Point>& footprint);

  double height_m(Point p) const { return gradient_.x * p.x + gradient_.y * p.y + offset_; }

  /// Change of height per metre along x and y.
  Point gradient() const { return gradient_; }

 private:
  Point gradient_;
  double offset_ = 0.0;
};

}  // namespace mapwright
