#include "navcore/localization/roaming.hpp"

#include <set>
#include <utility>
#include <vector>

namespace mapwright::navcore {
namespace {

constexpr double kStep_m = 0.5;
constexpr double kRoomy_m2 = 200.0;
constexpr int kTries = 50;

// A robot that strolls turns by this much at random (standard deviation) …
constexpr double kWander_deg = 10.0;
// … and looks for a way in these directions when there is none ahead.
constexpr double kDetour_deg = 15.0;
constexpr int kDetours = 12;
constexpr int kHalvings = 3;

bool can_drive(const FreeSpace& space, Point from, Point to, double radius_m) {
  return space.is_free(to, radius_m) && space.is_free_way(from, to, radius_m);
}

}  // namespace

double roaming_area_m2(const FreeSpace& space, Point p, double radius_m, double enough_m2) {
  if (!space.is_free(p, radius_m)) return 0.0;
  using Node = std::pair<int, int>;
  const auto place = [&](Node node) { return p + kStep_m * Point(node.first, node.second); };
  std::set<Node> seen{{0, 0}};
  std::vector<Node> open{{0, 0}};
  double area_m2 = 0.0;
  for (std::size_t i = 0; i < open.size() && area_m2 < enough_m2; ++i) {
    const Node node = open[i];
    area_m2 += kStep_m * kStep_m;
    for (const auto& [dx, dy] : {Node{1, 0}, Node{0, 1}, Node{-1, 0}, Node{0, -1}}) {
      const Node next{node.first + dx, node.second + dy};
      if (seen.count(next) > 0 || !can_drive(space, place(node), place(next), radius_m)) continue;
      seen.insert(next);
      open.push_back(next);
    }
  }
  return area_m2;
}

std::optional<Point> sample_roaming_place(const FreeSpace& space, double radius_m, Random& random) {
  std::optional<Point> best;
  double best_m2 = 0.0;
  for (int i = 0; i < kTries && best_m2 < kRoomy_m2; ++i) {
    const auto place = space.sample(random, radius_m);
    if (!place) break;
    const double area_m2 = roaming_area_m2(space, *place, radius_m, kRoomy_m2);
    if (area_m2 <= best_m2) continue;
    best_m2 = area_m2;
    best = place;
  }
  return best;
}

OdometryStep stroll(const FreeSpace& space, const Pose& pose, double distance_m, double radius_m,
                    Random& random) {
  const Angle wander = Angle::from_degrees(random.normal(0.0, kWander_deg));
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  for (int halving = 0; halving <= kHalvings; ++halving, distance_m *= 0.5) {
    for (int detour = 0; detour <= kDetours; ++detour) {
      for (const double hand : {side, -side}) {
        const Angle turn = wander + Angle::from_degrees(hand * detour * kDetour_deg);
        const OdometryStep step{turn, distance_m, Angle()};
        if (can_drive(space, pose.position(), moved(pose, step).position(), radius_m)) return step;
      }
    }
  }
  return {Angle::from_degrees(90.0), 0.0, Angle()};
}

}  // namespace mapwright::navcore
