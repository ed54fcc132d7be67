#include "navcore/rays/culled_ray_caster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mapcore/geometry/bounding_circle.hpp"
#include "navcore/rays/ramp_slope.hpp"
#include "navcore/rays/ray_fan.hpp"

namespace mapwright::navcore {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// The circle test is a superset on purpose: this much (radians) covers its rounding.
constexpr double kSectorSlack = 1e-9;

// Below this, relative to the squared distances of the ends, a segment's line may pass through the
// laser, and a ray may run along the segment.
constexpr double kCollinear = 1e-12;

struct Edge {
  Point a, b;
  double height_m;
};

struct Body {
  Circle circle;
  ShapeType type = ShapeType::kClosedPolygon;
  double max_height_m = 0.0;
  std::size_t first = 0, last = 0;  ///< edges [first, last)
  std::size_t ramp = 0;             ///< for ramps: position among the slopes
};

/// One scan while it is cast. Edges are given relative to the laser.
struct Scan {
  Point origin;
  Point ahead;
  double half_fov = 0.0;  ///< radians
  double height_m = 0.0;
  double max_range_m = 0.0;
  const RayFan& fan;
  std::span<double> ranges;
};

bool circle_meets_sector(const Circle& circle, const Scan& scan) {
  const Point d = circle.center - scan.origin;
  const double reach = scan.max_range_m + circle.radius_m;
  const double squared = squared_length(d);
  if (squared > reach * reach) return false;
  if (squared <= circle.radius_m * circle.radius_m) return true;
  const double bearing = std::abs(std::atan2(cross(scan.ahead, d), dot(scan.ahead, d)));
  const double half_width = std::asin(std::min(1.0, circle.radius_m / std::sqrt(squared)));
  return bearing <= scan.half_fov + half_width + kSectorSlack;
}

// Distance along the ray u from the origin to the closed segment ab; kNever where it misses. Sides
// of the ends are taken from the same products for both segments that share an end, so no ray slips
// between them.
double distance_to_segment(Point u, Point a, Point b) {
  const double side_a = cross(u, a);
  const double side_b = cross(u, b);
  if (side_a == 0.0 && side_b == 0.0) {
    const double along_a = dot(u, a);
    const double along_b = dot(u, b);
    if (std::max(along_a, along_b) < 0.0) return kNever;
    return std::max(0.0, std::min(along_a, along_b));
  }
  if (side_a * side_b > 0.0) return kNever;
  const double t = cross(a, b) / (side_b - side_a);
  return t >= 0.0 ? t : kNever;
}

// All rays against one wall whose line keeps clear of the laser, so that no ray runs along it and
// the division below never is 0 / 0 where the ray counts as a hit.
void cast_at_clear_wall(Point a, Point b, double twice_area, const Scan& scan) {
  const double* const x = scan.fan.x();
  const double* const y = scan.fan.y();
  double* const range = scan.ranges.data();
  const std::size_t rays = scan.ranges.size();
  for (std::size_t i = 0; i < rays; ++i) {
    const double side_a = x[i] * a.y - y[i] * a.x;
    const double side_b = x[i] * b.y - y[i] * b.x;
    const double t = twice_area / (side_b - side_a);
    const bool stops = (side_a * side_b <= 0.0) & (t >= 0.0) & (t < range[i]);
    range[i] = stops ? t : range[i];
  }
}

void cast_at_wall(const Edge& edge, const Scan& scan) {
  const Point a = edge.a - scan.origin;
  const Point b = edge.b - scan.origin;
  const Point nearest = closest_point_on_segment({0.0, 0.0}, a, b);
  if (squared_length(nearest) > scan.max_range_m * scan.max_range_m) return;
  const double twice_area = cross(a, b);
  if (std::abs(twice_area) > kCollinear * (squared_length(a) + squared_length(b))) {
    cast_at_clear_wall(a, b, twice_area, scan);
    return;
  }
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    scan.ranges[i] = std::min(scan.ranges[i], distance_to_segment(scan.fan[i], a, b));
  }
}

// Figure 6 of the report. Of a step and the top met at the same place the step counts.
double distance_to_stairs(Point u, std::span<const Edge> edges, const Scan& scan) {
  double top = kNever;   // first segment of height 0
  double step = kNever;  // first step
  double stop = kNever;  // first step higher than the laser
  for (const Edge& edge : edges) {
    const double t = distance_to_segment(u, edge.a - scan.origin, edge.b - scan.origin);
    double& first = edge.height_m > 0.0 ? step : top;
    first = std::min(first, t);
    if (edge.height_m > scan.height_m) stop = std::min(stop, t);
  }
  return top < step ? kNever : stop;
}

void cast_at_stairs(std::span<const Edge> edges, const Scan& scan) {
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    scan.ranges[i] = std::min(scan.ranges[i], distance_to_stairs(scan.fan[i], edges, scan));
  }
}

void cast_at_ramp(const RampSlope& slope, const Scan& scan) {
  const RampContour contour = slope.contour(scan.height_m);
  if (contour.pieces.empty()) return;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    scan.ranges[i] = std::min(scan.ranges[i], slope.distance_m(contour, scan.origin, scan.fan[i]));
  }
}

}  // namespace

struct CulledRayCaster::Obstacles {
  std::vector<Body> bodies;
  std::vector<Edge> edges;
  std::vector<RampSlope> slopes;

  explicit Obstacles(const Map& map) {
    bodies.reserve(map.obstacles.size());
    edges.reserve(segment_count(map));
    for (const auto& obstacle : map.obstacles) add(obstacle);
  }

  void add(const Obstacle& obstacle) {
    if (obstacle.segments.empty()) return;
    Body body;
    body.circle = min_bounding_circle(obstacle);
    body.type = obstacle.shape_type;
    body.first = edges.size();
    if (body.type == ShapeType::kRamp) {
      auto slope = RampSlope::of(obstacle);
      if (!slope) return;
      body.ramp = slopes.size();
      body.max_height_m = kNever;  // its contour says whether it reaches the laser
      slopes.push_back(*std::move(slope));
    } else {
      body.max_height_m = max_height_m(obstacle);
      for (const auto& s : obstacle.segments) edges.push_back({s.a, s.b, s.height_m});
    }
    body.last = edges.size();
    bodies.push_back(body);
  }

  void cast(const Scan& scan) const {
    std::fill(scan.ranges.begin(), scan.ranges.end(), scan.max_range_m);
    for (const Body& body : bodies) {
      if (body.max_height_m > scan.height_m && circle_meets_sector(body.circle, scan)) {
        cast_at(body, scan);
      }
    }
    for (double& range : scan.ranges) range = std::abs(range);  // never -0
  }

  void cast_at(const Body& body, const Scan& scan) const {
    const std::span<const Edge> own(edges.data() + body.first, body.last - body.first);
    switch (body.type) {
      case ShapeType::kStairs:
        cast_at_stairs(own, scan);
        break;
      case ShapeType::kRamp:
        cast_at_ramp(slopes[body.ramp], scan);
        break;
      default:
        for (const Edge& edge : own) {
          if (edge.height_m > scan.height_m) cast_at_wall(edge, scan);
        }
    }
  }
};

CulledRayCaster::CulledRayCaster(const Map& map)
    : obstacles_(std::make_unique<const Obstacles>(map)) {}
CulledRayCaster::CulledRayCaster(CulledRayCaster&&) noexcept = default;
CulledRayCaster& CulledRayCaster::operator=(CulledRayCaster&&) noexcept = default;
CulledRayCaster::~CulledRayCaster() = default;

void CulledRayCaster::cast(const Pose& pose, const LaserModel& laser,
                           std::span<double> ranges) const {
  cast_all({&pose, 1}, laser, ranges);
}

void CulledRayCaster::cast_all(std::span<const Pose> poses, const LaserModel& laser,
                               std::span<double> ranges) const {
  assert(ranges.size() == poses.size() * laser.rays);
  const RayFan relative(laser);
  RayFan fan(laser);
  const double half_fov = laser.rays <= 1 ? 0.0 : 0.5 * laser.fov_deg * std::numbers::pi / 180.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    fan.turn(relative, poses[i].theta);
    obstacles_->cast({poses[i].position(), unit_vector(poses[i].theta), half_fov, laser.height_m,
                      laser.max_range_m, fan, ranges.subspan(i * laser.rays, laser.rays)});
  }
}

}  // namespace mapwright::navcore
