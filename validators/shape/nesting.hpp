// Which ring holds which obstacle.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::validators {

class CheckContext;

/// The smallest ring around each obstacle. Obstacles that overlap a ring's outline count as held by
/// where their first segment, or for rings a point inside, lies.
class Nesting {
 public:
  explicit Nesting(const CheckContext& context);

  /// Position of the smallest ring that holds the obstacle.
  std::optional<std::size_t> holder(std::size_t obstacle) const;

  /// Positions of the obstacles that a ring holds directly, ascending.
  const std::vector<std::uint32_t>& held(std::size_t ring) const;

  /// Positions of all obstacles that a ring holds, and of all rings that hold one; ascending.
  const std::vector<std::uint32_t>& held_obstacles() const { return held_obstacles_; }
  const std::vector<std::uint32_t>& holders() const { return holders_; }

 private:
  std::unordered_map<std::size_t, std::uint32_t> holder_;
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> held_;
  std::vector<std::uint32_t> held_obstacles_, holders_, none_;
};

/// True if the ring at position `ring` holds the obstacle at position `obstacle`.
bool holds(const CheckContext& context, std::size_t ring, std::size_t obstacle);

}  // namespace mapwright::validators
