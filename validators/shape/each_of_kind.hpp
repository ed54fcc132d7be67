// The loops that checks of one kind of obstacle share.
#pragma once

#include "validators/check.hpp"
#include "validators/shape/flight.hpp"

namespace mapwright::validators {

/// Calls `check(obstacle, position, flight)` for each obstacle of shape type 5 that has segments,
/// all of which could be read, and is not proven to be a plain flight.
template <class CheckStairs>
void for_each_stairs(const CheckContext& context, const CheckStairs& check) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kStairs)) {
    if (obstacles[i].shape_type != ShapeType::kStairs || obstacles[i].segments.empty() ||
        !context.is_complete(i)) {
      continue;
    }
    check(obstacles[i], i, flight_of(obstacles[i]));
  }
}

/// Calls `check(obstacle, position)` for each obstacle of shape type 6 that has segments and is not
/// proven to be a plain ramp.
template <class CheckRamp>
void for_each_ramp(const CheckContext& context, const CheckRamp& check) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kRamp)) {
    if (obstacles[i].shape_type != ShapeType::kRamp || obstacles[i].segments.empty()) continue;
    check(obstacles[i], i);
  }
}

/// Calls `check(obstacle, position)` for each obstacle that may meet itself: not for sound rings,
/// which are known to be simple, nor for closed shapes without area, which are a finding of their
/// own.
template <class CheckChain>
void for_each_suspect_chain(const CheckContext& context, const CheckChain& check) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    const Outline& outline = context.outline(i);
    const bool is_flat_ring = is_closed(obstacles[i].shape_type) && outline.is_flat;
    if (!outline.is_ring && !is_flat_ring) check(obstacles[i], i);
  }
}

}  // namespace mapwright::validators
