#include "cli/plan/solver.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "cli/support/error.hpp"
#include "navcore/planning/path.hpp"

namespace mapwright::cli {
namespace {

using navcore::Connection;
using navcore::Route;

double straight_length_m(const std::vector<Point>& stops) {
  return navcore::path_length_m(stops);
}

const Obstacle& find_ramp(const Map& map, std::int64_t id) {
  for (const auto& obstacle : map.obstacles) {
    if (obstacle.id == id && obstacle.shape_type == ShapeType::kRamp) return obstacle;
  }
  fail_usage("the map has no ramp with id " + std::to_string(id));
}

}  // namespace

PlanSolver::PlanSolver(const Map& map, const PlanSettings& settings)
    : map_(map), settings_(settings), space_(map, settings.ramps), finder_(map, space_) {
  planner_ = find_planner(settings.planner)
                 .make({map_, space_, settings.ramps, settings.radius_m, settings.rrt});
  via_ = resolved_via();
  if (settings_.force_ramp) ramps_ = resolved_ramps();
}

std::vector<Point> PlanSolver::resolved_via() const {
  std::vector<Point> points;
  for (const auto& via : settings_.via) {
    const auto p = via.ramp ? point_on_ramp(space_, find_ramp(map_, *via.ramp), settings_.radius_m)
                            : located(via.place).at;
    if (!p) {
      throw Error(ExitStatus::kNegative,
                  via.ramp
                      ? "nowhere on ramp " + std::to_string(*via.ramp) + " is room for the robot"
                      : "there is no room for the robot beside " + place_text(via.place));
    }
    points.push_back(*p);
  }
  return points;
}

bool PlanSolver::is_in_largest_area(Point p) const {
  std::call_once(areas_made_, [this] {
    auto areas = navcore::TravelAreas::build(map_, settings_.radius_m, settings_.ramps);
    if (areas) areas_ = *std::move(areas);
  });
  return areas_ && areas_->area_at(p) == std::size_t{0};
}

Place PlanSolver::located(const Place& place) const {
  if (place.name.empty()) return place;
  const auto is_preferred = [this](Point p) { return is_in_largest_area(p); };
  return {finder_.standing_point(find_place(finder_, place.name), settings_.radius_m, is_preferred),
          place.name};
}

StartAndGoal PlanSolver::located(const StartAndGoal& query) const {
  return {located(query.start), located(query.goal)};
}

std::vector<Point> PlanSolver::resolved_ramps() const {
  std::vector<Point> points;
  for (const auto& obstacle : map_.obstacles) {
    if (obstacle.shape_type != ShapeType::kRamp) continue;
    if (const auto p = point_on_ramp(space_, obstacle, settings_.radius_m)) points.push_back(*p);
  }
  return points;
}

std::optional<std::string> PlanSolver::why_not_standing(const StartAndGoal& query) const {
  const auto why = [&](Point p, const char* what) {
    return cli::why_not_standing(map_, space_, p, settings_.radius_m, what);
  };
  const auto why_not_at = [&](const Place& place, const char* what) -> std::optional<std::string> {
    if (place.at) return why(*place.at, what);
    return std::string(what) + ": there is no room for the robot within 1 m of '" + place.name +
           "'";
  };
  if (auto reason = why_not_at(query.start, "start")) return reason;
  if (auto reason = why_not_at(query.goal, "goal")) return reason;
  for (const Point p : via_) {
    if (auto reason = why(p, "via-point")) return reason;
    if (!(space_.clearance_m(p) > 0.0)) {
      return "via-point " + place_text(p) + " lies on the outline of an obstacle";
    }
  }
  return std::nullopt;
}

PlanAnswer PlanSolver::answer(const StartAndGoal& query, std::size_t number) const {
  PlanAnswer answer{query, {}, 0.0, std::nullopt, {}};
  if (auto reason = why_not_standing(query)) {
    answer.reason = *std::move(reason);
    answer.route.total.reachable = false;
    return answer;
  }
  std::vector<Point> stops{*query.start.at};
  stops.insert(stops.end(), via_.begin(), via_.end());
  stops.push_back(*query.goal.at);
  const std::uint64_t seed = Random(settings_.seed, number)();
  answer.route =
      settings_.force_ramp ? shortest_over_a_ramp(stops, seed) : route_through(stops, seed);
  if (answer.route.total.solved) {
    answer.length_m = navcore::path_length_m(answer.route.total.path);
    answer.min_clearance_m = navcore::path_clearance_m(space_, answer.route.total.path);
  } else {
    explain_failure(stops, answer);
  }
  return answer;
}

Route PlanSolver::route_through(const std::vector<Point>& stops, std::uint64_t seed) const {
  return plan_route(space_, stops, settings_.radius_m, planner_, settings_.smoothing, seed);
}

// Each ramp is tried as the first stop after the start, the most promising first; the straight way
// through the stops is a lower bound that spares most of them.
Route PlanSolver::shortest_over_a_ramp(const std::vector<Point>& stops, std::uint64_t seed) const {
  std::vector<std::pair<double, std::vector<Point>>> ways;
  for (const Point ramp : ramps_) {
    if (reachability().connected(stops.front(), ramp) == Connection::kNo) continue;
    std::vector<Point> way = stops;
    way.insert(way.begin() + 1, ramp);
    const double bound_m = straight_length_m(way);
    ways.emplace_back(bound_m, std::move(way));
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const auto& p, const auto& q) { return p.first < q.first; });
  Route best;
  double best_m = 0.0;
  for (const auto& [bound_m, way] : ways) {
    if (best.total.solved && bound_m >= best_m) break;
    Route route = route_through(way, seed);
    if (!route.total.solved) continue;
    const double length_m = navcore::path_length_m(route.total.path);
    if (best.total.solved && length_m >= best_m) continue;
    best = std::move(route);
    best_m = length_m;
  }
  return best;
}

const navcore::ReachabilityMap& PlanSolver::reachability() const {
  std::call_once(reachability_made_, [this] {
    navcore::ReachabilityOptions options;
    options.radius_m = settings_.radius_m;
    reachability_.emplace(space_, options);
  });
  return *reachability_;
}

void PlanSolver::explain_failure(const std::vector<Point>& stops, PlanAnswer& answer) const {
  auto& total = answer.route.total;
  if (settings_.force_ramp && answer.route.failed_leg == 0) {
    answer.reason = ramps_.empty() ? "the map has no ramp with room for the robot"
                                   : "no path over a ramp was found";
    return;
  }
  if (!total.reason.empty()) {
    answer.reason = total.reason;
    return;
  }
  const std::size_t leg = answer.route.failed_leg;
  const Point from = stops[leg - 1];
  const Point to = stops[leg];
  const std::string way = place_text(from) + " to " + place_text(to);
  if (!total.reachable) {
    const Connection connection = reachability().connected(from, to);
    if (connection != Connection::kUndecided) total.reachable = connection == Connection::kYes;
  }
  if (total.reachable == false) {
    answer.reason = "there is no way from " + way + " for this robot (proved)";
  } else if (total.reachable == true) {
    answer.reason = "there is a way from " + way + " (proved), but none was found in " +
                    std::to_string(total.iterations) +
                    " iterations: raise --max-iterations or take another planner";
  } else {
    answer.reason = "no way from " + way + " was found in " + std::to_string(total.iterations) +
                    " iterations, which proves nothing";
  }
}

}  // namespace mapwright::cli
