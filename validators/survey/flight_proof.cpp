#include "validators/survey/flight_proof.hpp"

#include <algorithm>
#include <cmath>

#include "validators/shape/flight.hpp"
#include "validators/shape/line_angle.hpp"

namespace mapwright::validators {
namespace {

// Values seen so far.
struct Range {
  double least = HUGE_VAL, greatest = -HUGE_VAL;

  void add(double value) {
    least = std::isnan(value) ? -HUGE_VAL : std::min(least, value);
    greatest = std::isnan(value) ? HUGE_VAL : std::max(greatest, value);
  }
  // Then none differs by more from any other, nor from their median.
  bool spans_at_most(double difference) const { return !(greatest - least > difference); }
  bool lies_in(double from, double to) const {
    return least > greatest || (from <= least && greatest <= to);
  }
};

Point direction(const Segment& segment) {
  return segment.b - segment.a;
}

// T101, T104, T121.
bool rises_evenly(std::span<const Segment> steps, const ValidationOptions& options) {
  Range above_first;
  double below_m = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double rise_m = steps[k].height_m - below_m;
    const bool is_plausible =
        rise_m > 0.0 && options.min_step_rise_m <= rise_m && rise_m <= options.max_step_rise_m;
    if (!is_plausible) return false;
    if (k > 0) above_first.add(rise_m);
    below_m = steps[k].height_m;
  }
  return above_first.spans_at_most(options.max_rise_variation_m);
}

// T105, T106, T120, T122, T123, T124.
bool follows_evenly(std::span<const Segment> steps, const ValidationOptions& options) {
  Range treads;
  double width_below_m = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double width_m = distance(steps[k].a, steps[k].b);
    if (!(width_m >= options.min_step_width_m)) return false;
    if (k > 0) {
      const Segment &below = steps[k - 1], &step = steps[k];
      const bool is_even = std::max(width_m, width_below_m) <=
                           options.max_width_ratio * std::min(width_m, width_below_m);
      if (!is_even || dot(direction(below), direction(step)) < 0.0 ||
          !(line_angle_deg(below, step) <= options.max_step_turn_deg)) {
        return false;
      }
      treads.add(tread_m(below, step));
    }
    width_below_m = width_m;
  }
  return treads.lies_in(options.min_step_tread_m, options.max_step_tread_m) &&
         treads.spans_at_most(options.max_tread_variation_m);
}

// T102, T103, T125, T126.
bool is_closed_behind(const Segment& highest, const Segment& top,
                      const ValidationOptions& options) {
  const double behind = behind_m(highest, 0.5 * (top.a + top.b));
  return top.height_m == 0.0 && !(dot(direction(top), direction(highest)) > 0.0) &&
         -options.overlap_depth_m <= behind && behind <= options.max_step_tread_m &&
         line_angle_deg(highest, top) <= options.max_step_turn_deg;
}

}  // namespace

bool is_plain_flight(std::span<const Segment> segments, const ValidationOptions& options) {
  if (segments.size() < 2) return false;
  const auto steps = segments.first(segments.size() - 1);
  return is_closed_behind(steps.back(), segments.back(), options) && rises_evenly(steps, options) &&
         follows_evenly(steps, options);
}

}  // namespace mapwright::validators
