// Where one obstacle reaches into another.
#pragma once

#include <cstdint>
#include <optional>

#include "validators/check.hpp"
#include "validators/shape/pieces.hpp"
#include "validators/shape/solid.hpp"

namespace mapwright::validators {

/// A piece of a segment that lies where it should not.
struct Reach {
  std::uint32_t segment = 0;
  Piece piece;
};

/// The first piece of the obstacle's segments higher than 0 that lies in the solid, deeper than
/// `depth_m`.
std::optional<Reach> reach_into(const CheckContext& context, const Region& region,
                                std::uint32_t obstacle, double depth_m);

/// The first piece of the obstacle's segments higher than 0 that lies on the other side of the ring
/// than the piece it continues, both farther than `depth_m` from the ring.
std::optional<Reach> reach_across(const CheckContext& context, std::uint32_t ring,
                                  std::uint32_t obstacle, double depth_m);

/// True if all of the obstacle lies in the solid, deeper than `depth_m` where it begins, and meets
/// no edge of it.
bool lies_wholly_inside(const CheckContext& context, const Region& region, std::uint32_t obstacle,
                        double depth_m);

}  // namespace mapwright::validators
