// Where a robot can be: what blocks it, and which side of an outline is free.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
#include "mapcore/map.hpp"
#include "mapcore/random.hpp"

namespace mapwright::navcore {

/// How ramps are treated in planning (report, section 4.2).
enum class RampPolicy {
  kFree,   ///< driven across like open ground
  kAvoid,  ///< their footprints block
};

/// A piece of boundary that stops the robot.
struct BlockingSegment {
  Point a, b;
  std::uint32_t obstacle = 0;  ///< position in Map::obstacles
  /// Position in Obstacle::segments; nothing for the flanks of stairs, which the map does not list.
  std::optional<std::uint32_t> segment = std::nullopt;
};

/// All that blocks: segments higher than 0; of stairs every step, the closing segment and the two
/// flanks between the steps' ends; ramp footprints where they are to be avoided.
std::vector<BlockingSegment> blocking_segments(const Map& map, RampPolicy ramps);

/// The free space of a map for a point robot, and its clearance. Immutable; safe to query from many
/// threads.
///
/// A point is solid when it lies inside of a closed outline whose free side is the other one: the
/// inside of a counter-clockwise ring, unless a clockwise ring within that ring (a courtyard, the
/// inside of a room) holds the point too. Rings count when all their segments are higher than 0.
/// The areas of stairs, and of ramps that are to be avoided, are solid. Where the outermost rings
/// are clockwise, the map is drawn from inside, and what is outside of all rings is solid as well
/// (docs/decisions/0040-free-side-of-outlines.md).
class FreeSpace {
 public:
  explicit FreeSpace(const Map& map, RampPolicy ramps = RampPolicy::kFree);
  FreeSpace(FreeSpace&&) noexcept;
  FreeSpace& operator=(FreeSpace&&) noexcept;
  ~FreeSpace();

  const Border& border() const;
  const std::vector<BlockingSegment>& segments() const;
  const SegmentIndex& index() const;  ///< over segments(), same order

  /// True if p lies in the border and not inside of a solid. Boundaries are free.
  bool is_free(Point p) const;

  /// True if a disc of `radius_m` around p is inside the border and overlaps no solid: p is free
  /// and no blocking segment is nearer than the radius.
  bool is_free(Point p, double radius_m) const;

  /// Distance from a free point to what blocks it or to the border; 0 for a point that is not free.
  double clearance_m(Point p) const;

  /// True if the disc moves from a to b (each free for it) with no blocking segment nearer than the
  /// radius. For radius 0 the way may touch a blocking segment with its own ends, and nowhere else.
  bool is_free_way(Point a, Point b, double radius_m) const;

  /// Position in Map::obstacles of the obstacle that makes p not free (the smallest, where several
  /// do); nothing where p is free or outside of the border.
  std::optional<std::size_t> solid_at(Point p) const;

  /// A uniformly distributed free point; nothing if none was found in 100,000 draws. Draws fall
  /// where the map is not proved solid, so that a small free space in a wide border is found.
  std::optional<Point> sample(Random& random, double radius_m = 0.0) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::navcore
