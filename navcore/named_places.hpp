// Places that have a name: where a robot goes when it is sent to "Library".
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// A value of the semantic token `name=` (docs/format.md) and all obstacles that bear it.
struct NamedPlace {
  std::string name;
  std::vector<std::uint32_t> obstacles;  ///< positions in Map::obstacles, ascending
};

/// All names of the map in the order in which they first occur; empty values are none.
std::vector<NamedPlace> named_places(const Map& map);

/// Names that differ from `name` by a few letters, or by upper and lower case, or that hold it:
/// nearest first, at most `most`.
std::vector<std::string> similar_names(const std::vector<NamedPlace>& places, std::string_view name,
                                       std::size_t most = 3);

/// Finds places by name, and for a robot the point that stands for a place: a bench, a door or a
/// building is itself solid, so the robot goes to free ground beside it.
class PlaceFinder {
 public:
  /// Map and space must outlive this; `space` is that of the map.
  PlaceFinder(const Map& map, const FreeSpace& space);

  const std::vector<NamedPlace>& places() const { return places_; }

  /// The place of that name, to the letter; null where there is none.
  const NamedPlace* find(std::string_view name) const;

  /// Where a robot of `radius_m` stands when it is at the place.
  ///
  /// On a footprint that does not block (a ramp to be driven across): the point of it with most
  /// room (point_on_ramp). Beside what blocks: in front of the middle of the longest segment,
  /// `tolerance::kStandoff_m` beyond touching it, on its free side; where that is not free, the
  /// next of the points every half metre along all segments, then those farther away in steps of
  /// 10 cm, up to `tolerance::kBesidePlace_m`. Points for which `is_preferred` holds go before
  /// all others: a planner prefers those from which there is a way. Nothing where the robot can
  /// stand nowhere beside the place. Depends on nothing else: the same map, the same point.
  std::optional<Point> standing_point(
      const NamedPlace& place, double radius_m,
      const std::function<bool(Point)>& is_preferred = nullptr) const;

 private:
  // What blocks of a place, longest first.
  std::vector<BlockingSegment> outline_of(const NamedPlace& place) const;

  const Map& map_;
  const FreeSpace& space_;
  std::vector<NamedPlace> places_;
  std::vector<std::uint32_t> first_segment_;  // by obstacle, and one more: range of segments()
};

}  // namespace mapwright::navcore
