#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_stairs_missing_top(const CheckContext& context, FindingSink& sink) {
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    if (flight.top || flight.steps.empty()) return;
    const bool stands_at_foot = !flight.closing.empty();
    const std::size_t highest = flight.rises ? flight.steps.back() : flight.steps.front();
    sink.obstacle(FindingCode::T102, i, ObstacleField::kKeyword,
                  name_of(stairs) +
                      (stands_at_foot ? " has its segment of height 0 not beside its highest step"
                                      : " has no closing segment of height 0") +
                      "; add one that runs against the steps " +
                      (flight.rises ? "behind" : "before") + " segment " +
                      std::to_string(highest + 1));
  });
}

}  // namespace mapwright::validators
