#include "navcore/rays/brute_force_ray_caster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "mapcore/geometry/orientation.hpp"
#include "navcore/rays/ray_fan.hpp"

namespace mapwright::navcore {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Ray {
  Point origin;
  Point direction;  ///< unit length

  double along(Point p) const { return dot(direction, p - origin); }
  double across(Point p) const { return cross(direction, p - origin); }
  Point at(double t) const { return origin + t * direction; }
};

// Both ends lie on the ray's line: the nearest point of the segment that is not behind the origin.
double distance_along_line(const Ray& ray, const Segment& segment) {
  const auto [near, far] = std::minmax({ray.along(segment.a), ray.along(segment.b)});
  return far < 0.0 ? kNever : std::max(near, 0.0);
}

// Where the ray meets the segment: between the ends, in proportion to their distances from the
// ray's line. An end that lies on the line belongs to the segment.
double distance_to_segment(const Ray& ray, const Segment& segment) {
  const double a = ray.across(segment.a);
  const double b = ray.across(segment.b);
  if (a == 0.0 && b == 0.0) return distance_along_line(ray, segment);
  if ((a < 0.0 && b < 0.0) || (a > 0.0 && b > 0.0)) return kNever;
  const double t = (ray.along(segment.a) * b - ray.along(segment.b) * a) / (b - a);
  return t < 0.0 ? kNever : t;
}

double distance_to_walls(const Ray& ray, const Obstacle& obstacle, double height_m) {
  double nearest = kNever;
  for (const auto& segment : obstacle.segments) {
    if (segment.height_m <= height_m) continue;
    nearest = std::min(nearest, distance_to_segment(ray, segment));
  }
  return nearest;
}

// Figure 6 of the report: the first segment met decides whether the robot is upstairs. Of a step
// and the top met at the same place the step counts.
double distance_to_stairs(const Ray& ray, const Obstacle& stairs, double height_m) {
  struct Hit {
    double distance_m;
    double height_m;
  };
  std::vector<Hit> hits;
  for (const auto& segment : stairs.segments) {
    const double t = distance_to_segment(ray, segment);
    if (t < kNever) hits.push_back({t, segment.height_m});
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& p, const Hit& q) {
    return p.distance_m != q.distance_m ? p.distance_m < q.distance_m : p.height_m > q.height_m;
  });
  if (hits.empty() || hits.front().height_m <= 0.0) return kNever;
  const auto stop = std::find_if(hits.begin(), hits.end(),
                                 [&](const Hit& hit) { return hit.height_m > height_m; });
  return stop == hits.end() ? kNever : stop->distance_m;
}

// The ray stops where it runs into the rising plane, inside of the footprint.
double distance_to_ramp(const Ray& ray, const Obstacle& ramp, double height_m) {
  const auto normal = ramp_normal(ramp);
  if (!normal || normal->z <= 0.0 || ramp.segments.empty()) return kNever;
  const std::vector<Point> footprint = chain_points(ramp);
  const RampPlane plane(*normal, footprint);
  const double rise = dot(plane.gradient(), ray.direction);
  if (rise <= 0.0) return kNever;
  const double t = (height_m - plane.height_m(ray.origin)) / rise;
  if (t < 0.0 || side_of_ring(footprint, ray.at(t)) == PointSide::kOutside) return kNever;
  return t;
}

double distance_to_obstacle(const Ray& ray, const Obstacle& obstacle, double height_m) {
  switch (obstacle.shape_type) {
    case ShapeType::kStairs:
      return distance_to_stairs(ray, obstacle, height_m);
    case ShapeType::kRamp:
      return distance_to_ramp(ray, obstacle, height_m);
    default:
      return distance_to_walls(ray, obstacle, height_m);
  }
}

}  // namespace

double BruteForceRayCaster::cast_ray(Point origin, Point direction, double height_m,
                                     double max_range_m) const {
  double range = max_range_m;
  for (const auto& obstacle : obstacles_) {
    range = std::min(range, distance_to_obstacle({origin, direction}, obstacle, height_m));
  }
  return std::abs(range);  // never -0
}

void BruteForceRayCaster::cast(const Pose& pose, const LaserModel& laser,
                               std::span<double> ranges) const {
  assert(ranges.size() == laser.rays);
  RayFan fan(laser);
  fan.turn(RayFan(laser), pose.theta);
  for (std::size_t i = 0; i < laser.rays; ++i) {
    ranges[i] = cast_ray(pose.position(), fan[i], laser.height_m, laser.max_range_m);
  }
}

}  // namespace mapwright::navcore
