#include "bench/support/report_rays.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "navcore/rays/ray_fan.hpp"

namespace mapwright::bench {
namespace {

using navcore::LaserModel;
using navcore::RayFan;

constexpr double kNever = std::numeric_limits<double>::infinity();

// The scanner's semicircle, or whatever part of a circle its field of view is.
struct Sector {
  Point center, ahead;
  double radius_m, half_angle_rad;

  bool meets(const Circle& circle) const {
    const Point d = circle.center - center;
    const double distance = std::sqrt(squared_length(d));
    if (distance > radius_m + circle.radius_m) return false;
    if (distance <= circle.radius_m) return true;
    const double bearing = std::abs(std::atan2(cross(ahead, d), dot(ahead, d)));
    return bearing <= half_angle_rad + std::asin(circle.radius_m / distance);
  }
};

double distance_to_segment(Point origin, Point ray, const Segment& segment) {
  const Point a = segment.a - origin;
  const Point b = segment.b - origin;
  const double side_a = cross(ray, a);
  const double side_b = cross(ray, b);
  if (side_a == 0.0 && side_b == 0.0) {  // along the segment
    const auto [near, far] = std::minmax({dot(ray, a), dot(ray, b)});
    return far < 0.0 ? kNever : std::max(near, 0.0);
  }
  if (side_a * side_b > 0.0) return kNever;
  const double t = cross(a, b) / (side_b - side_a);
  return t >= 0.0 ? t : kNever;
}

double distance_to_walls(const Obstacle& walls, Point origin, Point ray, double height_m) {
  double nearest = kNever;
  for (const Segment& segment : walls.segments) {
    if (segment.height_m > height_m) {
      nearest = std::min(nearest, distance_to_segment(origin, ray, segment));
    }
  }
  return nearest;
}

// Figure 6 of the report.
double distance_to_stairs(const Obstacle& stairs, Point origin, Point ray, double height_m) {
  double top = kNever, step = kNever, stop = kNever;
  for (const Segment& segment : stairs.segments) {
    const double t = distance_to_segment(origin, ray, segment);
    double& first = segment.height_m > 0.0 ? step : top;
    first = std::min(first, t);
    if (segment.height_m > height_m) stop = std::min(stop, t);
  }
  return top < step ? kNever : stop;
}

// An obstacle whose circle the scanner's meets.
struct Left {
  explicit Left(const ReportRays::Body& b, double height_m) : body(&b) {
    if (b.slope) contour = b.slope->contour(height_m);
  }

  double distance(Point origin, Point ray, double height_m) const {
    if (body->slope) return body->slope->distance_m(contour, origin, ray);
    if (body->obstacle.shape_type == ShapeType::kStairs) {
      return distance_to_stairs(body->obstacle, origin, ray, height_m);
    }
    return distance_to_walls(body->obstacle, origin, ray, height_m);
  }

  const ReportRays::Body* body;
  navcore::RampContour contour;  ///< of ramps
};

}  // namespace

ReportRays::ReportRays(const Map& map) {
  for (const Obstacle& obstacle : map.obstacles) {
    if (obstacle.segments.empty()) continue;
    Body body{min_bounding_circle(obstacle), obstacle, std::nullopt};
    if (obstacle.shape_type == ShapeType::kRamp) {
      body.slope = navcore::RampSlope::of(obstacle);
      if (!body.slope) continue;  // stops no ray
    }
    bodies_.push_back(std::move(body));
  }
}

void ReportRays::cast(const Pose& pose, const LaserModel& laser, std::span<double> ranges) const {
  cast_all({&pose, 1}, laser, ranges);
}

void ReportRays::cast_all(std::span<const Pose> poses, const LaserModel& laser,
                          std::span<double> ranges) const {
  assert(ranges.size() == poses.size() * laser.rays);
  const double half_angle = laser.rays <= 1 ? 0.0 : 0.5 * laser.fov_deg * std::numbers::pi / 180.0;
  const RayFan relative(laser);
  RayFan fan(laser);
  std::vector<Left> left;
  double* range = ranges.data();
  for (const Pose& pose : poses) {
    const Point origin = pose.position();
    const Sector sector{origin, unit_vector(pose.theta), laser.max_range_m, half_angle + 1e-9};
    left.clear();
    for (const Body& body : bodies_) {
      if (sector.meets(body.circle)) left.emplace_back(body, laser.height_m);
    }
    fan.turn(relative, pose.theta);
    for (std::size_t i = 0; i < laser.rays; ++i) {
      double nearest = laser.max_range_m;
      for (const Left& obstacle : left) {
        nearest = std::min(nearest, obstacle.distance(origin, fan[i], laser.height_m));
      }
      *range++ = std::abs(nearest);  // never -0
    }
  }
}

}  // namespace mapwright::bench
