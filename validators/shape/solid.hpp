// The solid part of an outline: its inside without the courtyards in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
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

/// The body of an obstacle. Rings count as such when all their segments are higher than 0.
Body body_of(const CheckContext& context, std::size_t obstacle);

/// A solid ring without its holes. The context must outlive it.
class Region {
 public:
  Region(const CheckContext& context, std::uint32_t outer, std::vector<std::uint32_t> holes);

  std::uint32_t outer() const { return outer_; }

  /// True if p lies inside of the solid, deeper than `depth_m`.
  bool holds(Point p, double depth_m) const;

  /// Calls `visit(obstacle, segment)` for each edge whose box meets `box`.
  template <class Visit>
  void visit_edges(const Box& box, const Visit& visit) const {
    const auto visit_outline = [&](std::uint32_t outline) {
      context_.edges(outline).visit(box, [&](std::uint32_t e) { visit(outline, e); });
    };
    visit_outline(outer_);
    for_each_hole(box, visit_outline);
  }

 private:
  // Calls `visit(hole)` for each hole whose box meets `box`.
  void for_each_hole(const Box& box, const std::function<void(std::uint32_t)>& visit) const;

  const CheckContext& context_;
  std::uint32_t outer_;
  std::shared_ptr<const SegmentIndex> holes_;  // the diagonals of their boxes; null without holes
};

/// The solid ring at position `solid` without the courtyards in it. Requires Body::kSolid.
Region region_of(const CheckContext& context, std::uint32_t solid);

}  // namespace mapwright::validators
