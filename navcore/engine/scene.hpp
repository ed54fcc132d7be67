// Private to this folder: a map as rays see it, at no particular height.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/engine/item_bins.hpp"

namespace mapwright::navcore::engine {

struct SceneSegment {
  Point a, b;
  double height_m = 0.0;

  friend bool operator==(const SceneSegment&, const SceneSegment&) = default;
};

/// An obstacle that is no ramp: a run of the scene's segments.
struct SceneObstacle {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool stairs = false;
  /// The segments form one closed simple ring, so that crossing it always changes sides.
  bool simple_ring = false;
  bool counter_clockwise = false;  ///< of a simple ring
  double min_height_m = 0.0;
  Box box = kEmptyBox;
};

/// A ramp whose surface is not level.
struct SceneRamp {
  RampPlane plane;
  std::vector<Point> footprint;
};

/// Everything of a map that can ever stop a ray, found by place. Immutable once built.
///
/// Segments keep the order of the map; those of no length are left out, as no ray but one in a
/// continuum meets them. Ramps without a usable normal stop nothing and are left out too.
class Scene {
 public:
  explicit Scene(const Map& map);

  std::span<const SceneSegment> segments() const { return segments_; }
  std::span<const SceneObstacle> obstacles() const { return obstacles_; }
  std::span<const SceneRamp> ramps() const { return ramps_; }
  std::uint32_t obstacle_of(std::uint32_t segment) const { return obstacle_of_[segment]; }
  std::span<const SceneSegment> segments_of(const SceneObstacle& obstacle) const {
    return segments().subspan(obstacle.first, obstacle.count);
  }

  /// Items of the index: segment i is item i, ramp j is item segments().size() + j.
  const ItemBins& bins() const { return bins_; }
  bool is_ramp(std::uint32_t item) const { return item >= segments_.size(); }
  const SceneRamp& ramp(std::uint32_t item) const { return ramps_[item - segments_.size()]; }

  std::size_t memory_bytes() const;

 private:
  void add(const Obstacle& obstacle);
  void add_ramp(const Obstacle& obstacle);

  std::vector<SceneSegment> segments_;
  std::vector<std::uint32_t> obstacle_of_;
  std::vector<SceneObstacle> obstacles_;
  std::vector<SceneRamp> ramps_;
  ItemBins bins_;
};

}  // namespace mapwright::navcore::engine
