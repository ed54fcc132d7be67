// Which ring holds which obstacle.
#pragma once

#include <cstdint>
#include <optional>
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

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::uint32_t> holder_;
  std::vector<std::vector<std::uint32_t>> held_;
};

/// True if the ring at position `ring` holds the obstacle at position `obstacle`.
bool holds(const CheckContext& context, std::size_t ring, std::size_t obstacle);

}  // namespace mapwright::validators
