#include "validators/shape/flight.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

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

bool stand_side_by_side(const Segment& p, const Segment& q) {
  const Point along = p.b - p.a;
  const double p_m = length(along);
  if (p_m == 0.0) return false;
  const double from = dot(q.a - p.a, along) / p_m;
  const double to = dot(q.b - p.a, along) / p_m;
  const double shared_m = std::min(p_m, std::max(from, to)) - std::max(0.0, std::min(from, to));
  return shared_m < 0.5 * std::min(p_m, std::abs(to - from));
}

std::vector<Riser> risers_of(const Obstacle& stairs, const Flight& flight) {
  std::vector<Riser> risers;
  for (const std::size_t k : flight.steps) {
    const Segment& step = stairs.segments[k];
    const bool continues = !risers.empty() && risers.back().height_m == step.height_m &&
                           stand_side_by_side(stairs.segments[risers.back().pieces.back()], step);
    if (!continues) risers.push_back({{}, step.height_m, 0.0});
    risers.back().pieces.push_back(k);
    risers.back().width_m += distance(step.a, step.b);
  }
  if (!flight.rises) std::reverse(risers.begin(), risers.end());
  return risers;
}

double tread_m(const Segment& lower, const Segment& upper) {
  const Point along = lower.b - lower.a;
  const Point to_upper = 0.5 * (upper.a + upper.b) - 0.5 * (lower.a + lower.b);
  return std::abs(cross(along, to_upper)) / length(along);
}

double tread_m(const Obstacle& stairs, const Riser& lower, const Riser& upper) {
  return tread_m(stairs.segments[lower.pieces.front()], stairs.segments[upper.pieces.front()]);
}

double behind_m(const Segment& step, Point p) {
  const Point along = step.b - step.a;
  return cross(along, p - 0.5 * (step.a + step.b)) / length(along);
}

bool rises_plausibly(const std::vector<Riser>& risers, double min_rise_m, double max_rise_m) {
  double below_m = 0.0;
  return std::all_of(risers.begin(), risers.end(), [&](const Riser& riser) {
    const double rise_m = riser.height_m - below_m;
    below_m = riser.height_m;
    return min_rise_m <= rise_m && rise_m <= max_rise_m;
  });
}

double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace mapwright::validators
