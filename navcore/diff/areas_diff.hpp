// Private to this folder: connected parts of the ground, before and after.
#pragma once

#include <span>

#include "navcore/diff/navigation_diff.hpp"
#include "navcore/exact/exact_planner.hpp"

namespace mapwright::navcore {

/// `places` are free in both maps: they tell which part of the one is which of the other.
AreasDiff diff_areas(const ExactPlanner& before, const ExactPlanner& after,
                     std::span<const Point> places, double min_area_m2);

}  // namespace mapwright::navcore
