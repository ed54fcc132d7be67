#include <cmath>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Two rises say nothing about which of them is usual.
constexpr std::size_t kLeastRises = 3;

// Of each riser but the lowest: the ground before that one need not be level with the others.
std::vector<double> rises_m(const std::vector<Riser>& risers) {
  std::vector<double> rises;
  for (std::size_t n = 1; n < risers.size(); ++n) {
    rises.push_back(risers[n].height_m - risers[n - 1].height_m);
  }
  return rises;
}

}  // namespace

void check_stairs_irregular_rise(const CheckContext& context, FindingSink& sink) {
  const auto& options = context.options();
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    const auto risers = risers_of(stairs, flight);
    const auto rises = rises_m(risers);
    if (rises.size() < kLeastRises ||
        !rises_plausibly(risers, options.min_step_rise_m, options.max_step_rise_m)) {
      return;
    }
    const double usual_m = median(rises);
    for (std::size_t n = 0; n < rises.size(); ++n) {
      if (std::abs(rises[n] - usual_m) <= options.max_rise_variation_m) continue;
      const std::size_t k = risers[n + 1].pieces.front();
      sink.segment(FindingCode::T121, i, k, SegmentField::kHeight, stairs.segments[k].a,
                   name_of(stairs, k) + " rises " + metres(rises[n]) +
                       " m, the others of its flight " + metres(usual_m) +
                       " m; correct its height");
    }
  });
}

}  // namespace mapwright::validators
