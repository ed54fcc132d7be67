#include <algorithm>
#include <string>

#include "validators/check.hpp"
#include "validators/shape/leaning_walls.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Which side of an outline is free: docs/decisions/0010-orientation-of-outlines.md.

bool is_inner_ring(const Obstacle& obstacle) {
  return obstacle.semantic.value(semantic_key::kInnerOf).has_value();
}

bool is_all_indoor(const Obstacle& obstacle) {
  return std::all_of(obstacle.segments.begin(), obstacle.segments.end(),
                     [](const Segment& s) { return s.in_out == InOut::kIndoor; });
}

class Orientation {
 public:
  explicit Orientation(const CheckContext& context)
      : context_(context), obstacles_(context.map().obstacles) {}

  // What is wrong with the direction of a ring; empty where nothing is.
  std::string defect_of(std::size_t ring) const {
    const Obstacle& obstacle = obstacles_[ring];
    const bool clockwise = context_.outline(ring).is_clockwise_ring();
    if (obstacle.shape_type == ShapeType::kRamp) {
      return clockwise ? " runs clockwise, but the footprint of a ramp runs counter-clockwise" : "";
    }
    if (is_inner_ring(obstacle)) {
      return clockwise ? "" : " is an inner ring but runs counter-clockwise";
    }
    if (!clockwise || is_hollow(ring)) return "";
    return " runs clockwise, as if its inside were free, but it encloses nothing";
  }

 private:
  // A clockwise ring without inner_of: a courtyard, or a room seen from inside?
  bool is_hollow(std::size_t ring) const {
    const auto holder = context_.nesting().holder(ring);
    if (holder && context_.outline(*holder).is_counter_clockwise_ring()) return true;
    if (holds_something(ring)) return true;
    return !holder && (is_all_indoor(obstacles_[ring]) || fills_the_map(ring));
  }

  // What a ring calls its own inner ring is no sign of free space within it, nor is a courtyard
  // that lies in it directly: those belong to a solid.
  bool holds_something(std::size_t ring) const {
    const auto& held = context_.nesting().held(ring);
    return std::any_of(held.begin(), held.end(), [&](std::uint32_t i) {
      if (!context_.outline(i).is_clockwise_ring()) return true;
      return !is_inner_ring(obstacles_[i]) && context_.nesting().held(i).empty();
    });
  }

  bool fills_the_map(std::size_t ring) const {
    return context_.has_usable_border() &&
           context_.outline(ring).area_m2 > 0.5 * context_.map().border.area_m2();
  }

  const CheckContext& context_;
  const std::vector<Obstacle>& obstacles_;
};

void check_rings(const CheckContext& context, FindingSink& sink) {
  const Orientation orientation(context);
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    if (!context.outline(i).is_ring) continue;
    const std::string defect = orientation.defect_of(i);
    if (defect.empty()) continue;
    sink.obstacle(FindingCode::G107, i, ObstacleField::kKeyword,
                  name_of(context.map().obstacles[i]) + defect + "; reverse it");
  }
}

}  // namespace

void check_wrong_orientation(const CheckContext& context, FindingSink& sink) {
  check_rings(context, sink);
  check_leaning_walls(context, sink);
}

}  // namespace mapwright::validators
