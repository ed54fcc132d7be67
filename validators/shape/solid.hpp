// The solid part of an outline: its inside without the courtyards in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "validators/check.hpp"

namespace mapwright::validators {

/// What an obstacle is to others that come near it.
enum class Body : std::uint8_t {
  kNone,   ///< nothing that could be overlapped: ramps, height 0 only
  kSolid,  ///< a counter-clockwise ring, solid within
  kHole,   ///< a clockwise ring in a solid one: a courtyard
  kRoom,   ///< another clockwise ring: free within
  kWall,   ///< segments without inside: open walls, stairs, broken outlines
};

/// The bodies of all obstacles. Rings count as such when all their segments are higher than 0.
std::vector<Body> bodies_of(const CheckContext& context);

/// The outlines that bound a region, the outer one first.
using RegionOutlines = std::vector<std::uint32_t>;

/// A solid ring without its holes.
class Region {
 public:
  Region(const CheckContext& context, RegionOutlines outlines)
      : context_(context), outlines_(std::move(outlines)) {}

  std::uint32_t outer() const { return outlines_.front(); }

  /// True if p lies inside of the solid, deeper than `depth_m`.
  bool holds(Point p, double depth_m) const;

  /// Calls `visit(obstacle, segment)` for each edge whose box meets `box`.
  template <class Visit>
  void visit_edges(const Box& box, const Visit& visit) const {
    for (const auto outline : outlines_) {
      if (!boxes_meet(context_.outlines()[outline].box, box)) continue;
      context_.edges(outline).visit(box, [&](std::uint32_t e) { visit(outline, e); });
    }
  }

 private:
  static bool boxes_meet(const Box& p, const Box& q) {
    return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
  }

  const CheckContext& context_;
  RegionOutlines outlines_;
};

}  // namespace mapwright::validators
