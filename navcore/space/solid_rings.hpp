// Which side of the outlines of a map is solid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"
#include "navcore/space/ring_locator.hpp"

namespace mapwright::navcore {

/// The closed outlines of a map that have a solid side, and how they lie within each other.
///
/// Counter-clockwise outlines and footprints (stairs, avoided ramps) are solid within; clockwise
/// outlines (courtyards, rooms drawn from inside) take away from the solid rings they lie within.
class SolidRings {
 public:
  SolidRings(const Map& map, RampPolicy ramps);

  /// Position in Map::obstacles of the smallest ring that makes p solid; `kOutside` where p is
  /// outside of every ring of a map drawn from inside; nothing where p is not solid. Points on a
  /// ring are not solid by that ring.
  std::optional<std::size_t> solid_at(Point p) const;
  static constexpr std::size_t kOutside = SIZE_MAX;

  /// True if the outermost rings are hollow: the map is drawn from inside, as a floor plan is, and
  /// what lies outside of all rings is solid.
  bool drawn_from_inside() const { return drawn_from_inside_; }

 private:
  enum class Kind : std::uint8_t { kSolid, kHollow, kFootprint };
  struct Ring {
    std::uint32_t obstacle = 0;
    Kind kind = Kind::kSolid;
    double area_m2 = 0.0;
    std::vector<std::uint32_t> within;  // rings that this one lies in, ascending
    bool reaches_into_hollow = false;   // a vertex lies inside of a hollow ring
  };

  void collect(const Map& map, RampPolicy ramps, std::vector<RingPoints>& points);
  void nest(const std::vector<RingPoints>& points);
  void tie_inner_rings(const Map& map);
  bool is_hollowed_out(std::uint32_t solid, const std::vector<RingLocator::Holder>& holders) const;

  std::vector<Ring> rings_;
  std::optional<RingLocator> locator_;
  bool drawn_from_inside_ = false;
};

}  // namespace mapwright::navcore
