#include "navcore/planning/route.hpp"

#include <cassert>
#include <utility>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::navcore {
namespace {

void append_path(std::vector<Point>& path, const std::vector<Point>& leg) {
  const std::size_t shared = path.empty() ? 0 : 1;
  path.insert(path.end(), leg.begin() + static_cast<long>(shared), leg.end());
}

void keep_narrowest(PlanningResult& total, const PlanningResult& leg) {
  if (!leg.bottleneck_m) return;
  if (total.bottleneck_m && *total.bottleneck_m <= *leg.bottleneck_m) return;
  total.bottleneck_m = leg.bottleneck_m;
  total.bottleneck_at = leg.bottleneck_at;
}

void add_leg(PlanningResult& total, const PlanningResult& leg) {
  total.iterations += leg.iterations;
  total.tree.insert(total.tree.end(), leg.tree.begin(), leg.tree.end());
  total.is_shortest = leg.is_shortest;
  total.reason = leg.reason;
  total.caution = leg.caution;
  if (leg.reachable) total.reachable = total.reachable.value_or(true) && *leg.reachable;
  total.barrier.insert(total.barrier.end(), leg.barrier.begin(), leg.barrier.end());
  keep_narrowest(total, leg);
}

Point mean(const std::vector<Point>& points) {
  Point sum{};
  for (const Point p : points) sum = sum + p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

}  // namespace

Route plan_route(const FreeSpace& space, std::span<const Point> stops, double radius_m,
                 const LegPlanner& plan_leg, const std::optional<SmoothingOptions>& smoothing,
                 std::uint64_t seed) {
  assert(stops.size() >= 2);
  Route route;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    Random planning(seed, 2 * i);
    const PlanningResult leg = plan_leg({stops[i - 1], stops[i], radius_m}, planning);
    add_leg(route.total, leg);
    if (!leg.solved) {
      route.failed_leg = i;
      route.total.path.clear();
      route.raw_path.clear();
      return route;
    }
    append_path(route.raw_path, leg.path);
    Random shortcuts(seed, 2 * i + 1);
    append_path(route.total.path,
                smoothing && !leg.is_shortest
                    ? smooth_path(space, leg.path, radius_m, *smoothing, shortcuts)
                    : leg.path);
  }
  route.total.solved = true;
  return route;
}

std::optional<Point> point_on_ramp(const FreeSpace& space, const Obstacle& ramp, double radius_m) {
  const std::vector<Point> footprint = chain_points(ramp);
  if (footprint.size() < 3) return std::nullopt;
  const Box box = extent(ramp);
  Random random(0, static_cast<std::uint64_t>(ramp.id));
  std::optional<Point> best;
  double best_clearance_m = 0.0;
  Point p = mean(footprint);
  for (int found = 0, draws = 0; found <= 64 && draws < 6400; ++draws) {
    if (side_of_ring(footprint, p) == PointSide::kInside) {
      ++found;
      const double clearance_m = space.clearance_m(p);
      if (clearance_m > best_clearance_m && clearance_m >= radius_m) {
        best = p;
        best_clearance_m = clearance_m;
      }
    }
    p.x = random.uniform(box.min_x, box.max_x);
    p.y = random.uniform(box.min_y, box.max_y);
  }
  return best;
}

}  // namespace mapwright::navcore
