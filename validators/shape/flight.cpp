#include "validators/shape/flight.hpp"

#include <algorithm>

namespace mapwright::validators {
namespace {

Point direction(const Obstacle& stairs, std::size_t k) {
  return stairs.segments[k].b - stairs.segments[k].a;
}

bool most_steps_rise(const Obstacle& stairs, const Flight& flight) {
  int balance = 0;
  for (std::size_t i = 1; i < flight.steps.size(); ++i) {
    const double before = stairs.segments[flight.steps[i - 1]].height_m;
    const double height = stairs.segments[flight.steps[i]].height_m;
    balance += height > before ? 1 : (height < before ? -1 : 0);
  }
  if (balance != 0 || flight.closing.empty() || flight.steps.empty()) return balance >= 0;
  return flight.closing.front() > flight.steps.front();
}

std::optional<std::size_t> top_of(const Flight& flight) {
  if (flight.closing.empty() || flight.steps.empty()) return std::nullopt;
  const std::size_t candidate = flight.rises ? flight.closing.back() : flight.closing.front();
  const bool is_beyond_steps =
      flight.rises ? candidate > flight.steps.back() : candidate < flight.steps.front();
  return is_beyond_steps ? std::optional(candidate) : std::nullopt;
}

std::vector<bool> facing(const Obstacle& stairs, const std::vector<std::size_t>& steps) {
  std::vector<bool> same(steps.size(), true);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double cosine = dot(direction(stairs, steps[i - 1]), direction(stairs, steps[i]));
    same[i] = cosine < 0.0 ? !same[i - 1] : same[i - 1];
  }
  const auto agreeing = static_cast<std::size_t>(std::count(same.begin(), same.end(), true));
  if (2 * agreeing < steps.size()) same.flip();
  return same;
}

}  // namespace

Flight flight_of(const Obstacle& stairs) {
  Flight flight;
  for (std::size_t k = 0; k < stairs.segments.size(); ++k) {
    const Segment& segment = stairs.segments[k];
    if (segment.a == segment.b) continue;
    (segment.height_m == 0.0 ? flight.closing : flight.steps).push_back(k);
  }
  flight.rises = most_steps_rise(stairs, flight);
  flight.top = top_of(flight);
  flight.faces_as_most = facing(stairs, flight.steps);
  return flight;
}

}  // namespace mapwright::validators
