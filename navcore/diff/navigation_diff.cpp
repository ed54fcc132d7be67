#include "navcore/diff/navigation_diff.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "navcore/diff/areas_diff.hpp"
#include "navcore/diff/common_places.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "navcore/exact/exact_planner.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

constexpr std::size_t kMostFocused = 50;  // boxes to look at closely
constexpr std::size_t kPosesABox = 4;
constexpr double kAround_m = 5.0;

// Streams of random numbers, so that one kind of sample does not move another.
enum class Stream : std::uint64_t { kScans = 0, kFocused = 1, kRoutes = 2 };

Random random_of(const NavigationDiffSettings& settings, Stream stream, std::size_t i) {
  return Random(settings.seed, (static_cast<std::uint64_t>(stream) << 40U) + i);
}

// At most kMostFocused of the boxes, evenly taken.
std::vector<Box> focused(const std::vector<Box>& boxes) {
  if (boxes.size() <= kMostFocused) return boxes;
  std::vector<Box> some;
  for (std::size_t i = 0; i < kMostFocused; ++i) {
    some.push_back(boxes[i * boxes.size() / kMostFocused]);
  }
  return some;
}

Pose pose_at(Point p, Random& random) {
  const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  return {p.x, p.y, Angle::from_radians(heading)};
}

struct Poses {
  std::vector<Pose> all;
  std::size_t sampled = 0;  ///< the first so many; behind them those around changes
};

Poses poses_for_scans(const CommonPlaces& places, const NavigationDiffSettings& settings) {
  Poses poses;
  for (std::size_t i = 0; i < settings.scans; ++i) {
    Random random = random_of(settings, Stream::kScans, i);
    if (const auto p = places.sample(random)) poses.all.push_back(pose_at(*p, random));
  }
  poses.sampled = poses.all.size();
  if (settings.scans == 0) return poses;
  const auto boxes = focused(settings.focus);
  for (std::size_t i = 0; i < boxes.size() * kPosesABox; ++i) {
    Random random = random_of(settings, Stream::kFocused, i);
    const auto p = places.sample_in(boxes[i / kPosesABox].inflated(kAround_m), random);
    if (p) poses.all.push_back(pose_at(*p, random));
  }
  return poses;
}

ScanDifference compare_scans(const float* before, const float* after,
                             const NavigationDiffSettings& settings) {
  ScanDifference difference;
  for (std::size_t i = 0; i < settings.laser.rays; ++i) {
    const double apart_m = std::abs(static_cast<double>(before[i]) - static_cast<double>(after[i]));
    if (apart_m > settings.scan_tolerance_m) ++difference.rays;
    difference.largest_m = std::max(difference.largest_m, apart_m);
  }
  return difference;
}

ScansDiff diff_scans(const Map& before, const Map& after, const Poses& poses,
                     const NavigationDiffSettings& settings) {
  const std::size_t rays = settings.laser.rays;
  std::vector<float> old_ranges(poses.all.size() * rays);
  std::vector<float> new_ranges(poses.all.size() * rays);
  const unsigned threads = settings.threads;
  ScanEngine(before).cast_all(poses.all, settings.laser, old_ranges, threads);
  ScanEngine(after).cast_all(poses.all, settings.laser, new_ranges, threads);
  ScansDiff diff;
  diff.sampled = poses.sampled;
  diff.focused = poses.all.size() - poses.sampled;
  for (std::size_t i = 0; i < poses.all.size(); ++i) {
    auto difference = compare_scans(&old_ranges[i * rays], &new_ranges[i * rays], settings);
    if (difference.rays == 0) continue;
    difference.pose = poses.all[i];
    difference.is_sampled = i < poses.sampled;
    ++(difference.is_sampled ? diff.sampled_changed : diff.focused_changed);
    diff.changed.push_back(difference);
  }
  return diff;
}

using Pair = std::pair<Point, Point>;

std::vector<Pair> all_pairs(const std::vector<Point>& places) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size(); ++j) pairs.emplace_back(places[i], places[j]);
  }
  return pairs;
}

std::vector<Pair> random_pairs(const CommonPlaces& places, const NavigationDiffSettings& settings) {
  std::vector<Pair> pairs;
  const auto boxes = focused(settings.focus);
  for (std::size_t i = 0; i < settings.routes; ++i) {
    Random random = random_of(settings, Stream::kRoutes, i);
    const bool near_change = i % 2 == 1 && !boxes.empty();
    const auto start =
        near_change ? places.sample_in(boxes[i / 2 % boxes.size()].inflated(kAround_m), random)
                    : places.sample(random);
    const auto goal = places.sample(random);
    if (start && goal) pairs.emplace_back(*start, *goal);
  }
  return pairs;
}

bool can_tell(const ExactAnswer& answer) {
  return answer.start == PlaceState::kFree && answer.goal == PlaceState::kFree &&
         answer.verdict != Verdict::kUndecided;
}

void compare_routes(const Pair& pair, ExactAnswer before, ExactAnswer after, double tolerance_m,
                    RoutesDiff& diff) {
  ++diff.tried;
  const bool was = before.verdict == Verdict::kReachable;
  const bool is = after.verdict == Verdict::kReachable;
  if (!was && !is) return;
  if (was && is) {
    if (std::abs(before.length_m - after.length_m) <= tolerance_m) return;
    ++(after.length_m > before.length_m ? diff.longer : diff.shorter);
  } else {
    ++(was ? diff.impossible : diff.possible);
  }
  RouteDifference route{pair.first,           pair.second, {}, {}, std::move(before.path),
                        std::move(after.path)};
  if (was) route.before_m = before.length_m;
  if (is) route.after_m = after.length_m;
  diff.changed.push_back(std::move(route));
}

RoutesDiff diff_routes(const ExactPlanner& before, const ExactPlanner& after,
                       const std::vector<Pair>& pairs, double tolerance_m) {
  RoutesDiff diff;
  ExactWorkspace workspace_before;
  ExactWorkspace workspace_after;
  for (const auto& pair : pairs) {
    auto was = before.plan(pair.first, pair.second, workspace_before);
    auto is = after.plan(pair.first, pair.second, workspace_after);
    if (can_tell(was) && can_tell(is)) {
      compare_routes(pair, std::move(was), std::move(is), tolerance_m, diff);
    }
  }
  return diff;
}

}  // namespace

Result<NavigationDiff> diff_navigation(const Map& before, const Map& after,
                                       const NavigationDiffSettings& settings) {
  const Map* maps[] = {&before, &after};
  std::array<std::optional<Result<ExactPlanner>>, 2> planners;
  const ExactOptions robot{settings.robot_radius_m, settings.ramps,
                           ExactOptions{}.tangents_a_quadrant};
  parallel_for(2, 1, settings.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      planners[i].emplace(ExactPlanner::build(*maps[i], robot));
  });
  for (auto& planner : planners) {
    if (!*planner) return tl::unexpected(std::move(planner->error()));
  }
  const CommonPlaces places(before, after, settings.ramps, settings.robot_radius_m);
  const Poses poses = poses_for_scans(places, settings);
  std::vector<Point> known;
  for (const auto& pose : poses.all) known.push_back(pose.position());
  NavigationDiff diff;
  diff.scans = diff_scans(before, after, poses, settings);
  diff.areas = diff_areas(**planners[0], **planners[1], known, settings.min_area_m2);
  diff.routes = diff_routes(
      **planners[0], **planners[1],
      settings.places.empty() ? random_pairs(places, settings) : all_pairs(settings.places),
      settings.route_tolerance_m);
  return diff;
}

}  // namespace mapwright::navcore
