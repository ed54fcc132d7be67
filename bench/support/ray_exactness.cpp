#include "bench/support/ray_exactness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "mapcore/random.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/ray_fan.hpp"

namespace mapwright::bench {
namespace {

using navcore::BruteForceRayCaster;
using navcore::LaserModel;
using navcore::RayFan;

struct Ranges {
  double least, most;
};

// Between these the exact range changes when the ray moves sideways.
Ranges when_moved(const BruteForceRayCaster& exact, Point origin, Point direction,
                  const LaserModel& laser, double range_m) {
  Ranges ranges{range_m, range_m};
  const Point aside{-direction.y, direction.x};
  for (const double by : {-kSideways_m, -0.5 * kSideways_m, 0.5 * kSideways_m, kSideways_m}) {
    const double moved =
        exact.cast_ray(origin + by * aside, direction, laser.height_m, laser.max_range_m);
    ranges = {std::min(ranges.least, moved), std::max(ranges.most, moved)};
  }
  return ranges;
}

// Angle between the ray and what it meets, from how the range changes.
double incidence_rad(const Ranges& ranges) {
  return std::atan2(2.0 * kSideways_m, ranges.most - ranges.least);
}

std::string describe(const Pose& pose, std::size_t ray, double actual, double expected) {
  char text[200];
  std::snprintf(text, sizeof(text), "pose %.17g,%.17g,%.17g deg, ray %zu: %.9g, exact %.9g", pose.x,
                pose.y, pose.theta.degrees(), ray, actual, expected);
  return text;
}

class Comparison {
 public:
  Comparison(const Map& map, const LaserModel& laser) : exact_(map), laser_(laser), fan_(laser) {}

  void compare(const Pose& pose, std::span<const double> actual, std::span<const double> expected) {
    for (std::size_t i = 0; i < laser_.rays; ++i) {
      const double error = std::abs(actual[i] - expected[i]);
      ++result.rays;
      result.stopped += expected[i] < laser_.max_range_m ? 1 : 0;
      if (error <= kCloseLook_m) {
        result.worst_error_m = std::max(result.worst_error_m, error);
      } else if (!look_closely(pose, i, actual[i], expected[i])) {
        if (result.wrong++ == 0) result.first_wrong = describe(pose, i, actual[i], expected[i]);
      }
    }
  }

  Exactness result;

 private:
  bool look_closely(const Pose& pose, std::size_t ray, double actual, double expected) {
    const Point ahead = unit_vector_deg(pose.theta.degrees());
    const Point r = fan_[ray];
    const Point direction{ahead.x * r.x - ahead.y * r.y, ahead.y * r.x + ahead.x * r.y};
    const Ranges moved = when_moved(exact_, pose.position(), direction, laser_, expected);
    const double incidence = incidence_rad(moved);
    if (incidence < kGrazing_deg * std::numbers::pi / 180.0) {
      ++result.grazing;
      return actual >= moved.least - kTolerance_m && actual <= moved.most + kTolerance_m;
    }
    const double error = std::abs(actual - expected);
    result.worst_error_m = std::max(result.worst_error_m, error);
    result.worst_scaled_m = std::max(result.worst_scaled_m, error * std::sin(incidence));
    return error <= kTolerance_m;
  }

  BruteForceRayCaster exact_;
  const LaserModel& laser_;
  RayFan fan_;
};

}  // namespace

void Exactness::add(const Exactness& other) {
  if (wrong == 0) first_wrong = other.first_wrong;
  rays += other.rays;
  stopped += other.stopped;
  grazing += other.grazing;
  wrong += other.wrong;
  worst_error_m = std::max(worst_error_m, other.worst_error_m);
  worst_scaled_m = std::max(worst_scaled_m, other.worst_scaled_m);
}

Exactness measure_exactness(const Map& map, const navcore::RayCaster& caster,
                            const navcore::RayCaster& reference, std::span<const Pose> poses,
                            const LaserModel& laser) {
  Comparison comparison(map, laser);
  std::vector<double> actual(poses.size() * laser.rays);
  std::vector<double> expected(actual.size());
  caster.cast_all(poses, laser, actual);
  reference.cast_all(poses, laser, expected);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto scan = [&](const std::vector<double>& all) {
      return std::span(all).subspan(i * laser.rays, laser.rays);
    };
    comparison.compare(poses[i], scan(actual), scan(expected));
  }
  return comparison.result;
}

std::vector<Pose> poses_everywhere(const Map& map, std::size_t count, std::uint64_t seed) {
  const Box area = map.border.box().inflated(3.0);
  Random random(seed);
  const auto round_to_decimetre = [](double value) { return std::round(value * 10.0) / 10.0; };
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    Pose pose{random.uniform(area.min_x, area.max_x), random.uniform(area.min_y, area.max_y),
              Angle::from_degrees(random.uniform(-180.0, 180.0))};
    if (i % 10 == 3) pose = {round_to_decimetre(pose.x), round_to_decimetre(pose.y), pose.theta};
    if (i % 10 < 2) pose.theta = Angle::from_degrees(90.0 * static_cast<double>(random.below(4)));
    poses.push_back(pose);
  }
  return poses;
}

std::vector<Pose> poses_in_clusters(const Map& map, std::size_t count, std::uint64_t seed) {
  constexpr std::size_t kEach = 24;
  const std::vector<Pose> places = poses_everywhere(map, count / kEach + 1, seed);
  Random random(seed);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose& place = places[i / kEach];
    const double spread_deg = i / kEach % 4 == 3 ? 180.0 : 3.0;
    poses.push_back({random.normal(place.x, 0.3), random.normal(place.y, 0.3),
                     place.theta + Angle::from_degrees(random.normal(0.0, spread_deg))});
  }
  return poses;
}

}  // namespace mapwright::bench
