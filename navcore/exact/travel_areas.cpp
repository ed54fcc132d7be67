#include "navcore/exact/travel_areas.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace mapwright::navcore {
namespace {

constexpr int kTangents = 8;

// Gives each component the number of its group: components that the offset's error alone keeps
// apart belong together. What cannot be asked is a group of its own.
std::vector<std::size_t> group_components(const ExactPlanner& planner,
                                          const std::vector<FreeComponent>& components,
                                          double radius_m) {
  std::vector<std::size_t> group_of(components.size());
  std::iota(group_of.begin(), group_of.end(), std::size_t{0});
  if (!(radius_m > 0.0) || components.size() < 2) return group_of;  // exact as they are
  std::unordered_map<std::size_t, std::size_t> group_of_region;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto region = planner.region_at(components[i].somewhere, radius_m);
    if (region) group_of[i] = group_of_region.emplace(*region, i).first->second;
  }
  return group_of;
}

void add_box(Box& box, const Box& other) {
  box.add({other.min_x, other.min_y});
  box.add({other.max_x, other.max_y});
}

}  // namespace

Result<TravelAreas> TravelAreas::build(const Map& map, double radius_m, RampPolicy ramps) {
  auto planner = ExactPlanner::build(map, {radius_m, ramps, kTangents});
  if (!planner) return tl::unexpected(planner.error());
  return TravelAreas(std::move(*planner), radius_m);
}

TravelAreas::TravelAreas(ExactPlanner planner, double radius_m) : planner_(std::move(planner)) {
  auto components = planner_.components();
  for (const auto& component : components) free_area_m2_ += component.area_m2;
  area_of_component_.resize(components.size());
  // Largest first, so those too small to be listed come last.
  std::erase_if(components, [](const FreeComponent& c) { return c.area_m2 < kLeastArea_m2; });
  const auto group_of = group_components(planner_, components, radius_m);
  for (std::size_t i = 0; i < components.size(); ++i) add(components[i], i, group_of[i]);
  rank();
  for (std::size_t i = 1; i < areas_.size(); ++i) {
    areas_[i].gap = planner_.bottleneck(areas_[i].at, areas_[0].at);
  }
}

// The first component of a group, its largest, stands for it.
void TravelAreas::add(const FreeComponent& component, std::size_t number, std::size_t group) {
  if (group == number) {
    area_of_component_[number] = areas_.size();
    areas_.push_back({component.area_m2, component.somewhere, component.box, {}});
    return;
  }
  area_of_component_[number] = area_of_component_[group];
  TravelArea& area = areas_[*area_of_component_[group]];
  area.area_m2 += component.area_m2;
  add_box(area.box, component.box);
}

// Groups of several components may have grown larger than those before them.
void TravelAreas::rank() {
  std::vector<std::size_t> order(areas_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
    return areas_[p].area_m2 > areas_[q].area_m2;
  });
  std::vector<std::size_t> rank_of(order.size());
  std::vector<TravelArea> ranked;
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank_of[order[i]] = i;
    ranked.push_back(areas_[order[i]]);
  }
  areas_ = std::move(ranked);
  for (auto& area : area_of_component_) {
    if (area) area = rank_of[*area];
  }
}

double TravelAreas::largest_fraction() const {
  return areas_.empty() ? 0.0 : areas_.front().area_m2 / free_area_m2_;
}

std::optional<std::size_t> TravelAreas::area_at(Point p) const {
  const auto component = planner_.component_at(p);
  if (!component) return std::nullopt;
  return area_of_component_[*component];
}

}  // namespace mapwright::navcore
