#include "navcore/diff/areas_diff.hpp"

#include <set>
#include <utility>

namespace mapwright::navcore {
namespace {

// Which components of the two maps share a place.
using Relation = std::set<std::pair<std::size_t, std::size_t>>;

void relate(const ExactPlanner& before, const ExactPlanner& after, Point p, Relation& relation) {
  const auto b = before.component_at(p);
  const auto a = after.component_at(p);
  if (b && a) relation.emplace(*b, *a);
}

using Components = std::vector<FreeComponent>;

// Components of one map with those of the other that share ground with them.
struct Side {
  const Components& own;
  const Components& other;
  const Relation& relation;  ///< own first
};

std::size_t partners(const Side& side, std::size_t component, double min_area_m2) {
  std::size_t count = 0;
  for (auto at = side.relation.lower_bound({component, 0});
       at != side.relation.end() && at->first == component; ++at) {
    count += side.other[at->second].area_m2 >= min_area_m2 ? 1 : 0;
  }
  return count;
}

void tell(const Side& side, AreaDifference::Kind alone, AreaDifference::Kind several,
          double min_area_m2, std::vector<AreaDifference>& changed) {
  for (std::size_t i = 0; i < side.own.size(); ++i) {
    const auto& component = side.own[i];
    if (component.area_m2 < min_area_m2) continue;
    const bool related = side.relation.lower_bound({i, 0}) != side.relation.lower_bound({i + 1, 0});
    if (!related) changed.push_back({alone, component.somewhere, component.area_m2, 1});
    const std::size_t parts = partners(side, i, min_area_m2);
    if (parts > 1) changed.push_back({several, component.somewhere, component.area_m2, parts});
  }
}

Relation turned(const Relation& relation) {
  Relation other;
  for (const auto& [b, a] : relation) other.emplace(a, b);
  return other;
}

void measure(const Components& components, double min_area_m2, std::size_t& count, double& area) {
  for (const auto& component : components) {
    area += component.area_m2;
    count += component.area_m2 >= min_area_m2 ? 1 : 0;
  }
}

}  // namespace

AreasDiff diff_areas(const ExactPlanner& before, const ExactPlanner& after,
                     std::span<const Point> places, double min_area_m2) {
  const Components old_ones = before.components();
  const Components new_ones = after.components();
  Relation relation;
  for (const Point p : places) relate(before, after, p, relation);
  for (const auto& component : old_ones) relate(before, after, component.somewhere, relation);
  for (const auto& component : new_ones) relate(before, after, component.somewhere, relation);
  AreasDiff diff;
  measure(old_ones, min_area_m2, diff.components_before, diff.free_before_m2);
  measure(new_ones, min_area_m2, diff.components_after, diff.free_after_m2);
  using Kind = AreaDifference::Kind;
  const Relation back = turned(relation);
  tell({old_ones, new_ones, relation}, Kind::kVanished, Kind::kSplit, min_area_m2, diff.changed);
  tell({new_ones, old_ones, back}, Kind::kAppeared, Kind::kJoined, min_area_m2, diff.changed);
  return diff;
}

}  // namespace mapwright::navcore
