#include "tests/navcore_exact/slow_paths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace mapwright::test {
namespace {

using navcore::BlockingSegment;

constexpr double kTiny = 1e-7;
constexpr double kStep_m = 1e-4;  // from a wall to a point beside it

// Sides of a directed line on which a path may pass.
struct Sides {
  bool left = true, right = true;
  bool any() const { return left || right; }
};

double turned(double from_rad, double to_rad) {
  double turn = std::fmod(to_rad - from_rad, 2.0 * std::numbers::pi);
  if (turn < 0.0) turn += 2.0 * std::numbers::pi;
  return turn > 2.0 * std::numbers::pi - kTiny ? 0.0 : turn;
}

double bearing(Point d) {
  return std::atan2(d.y, d.x);
}

class SlowPlanner {
 public:
  explicit SlowPlanner(const Map& map)
      : space_(map), walls_(navcore::blocking_segments(map, navcore::RampPolicy::kFree)) {
    const Box b = map.border.box();
    const Point corners[] = {
        {b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}};
    for (int i = 0; i < 4; ++i) walls_.push_back({corners[i], corners[(i + 1) % 4], 0});
  }

  std::optional<double> length_m(Point start, Point goal) {
    corners_ = {start, goal};
    for (const auto& wall : walls_) {
      for (const Point p : {wall.a, wall.b}) {
        if (std::find(corners_.begin(), corners_.end(), p) == corners_.end()) corners_.push_back(p);
      }
    }
    bearings_.clear();
    for (const Point p : corners_) bearings_.push_back(wall_bearings(p));
    return dijkstra();
  }

 private:
  struct State {
    std::size_t corner, sector;
  };

  // Directions in which walls leave p, ascending.
  std::vector<double> wall_bearings(Point p) const {
    std::vector<double> result;
    for (const auto& wall : walls_) {
      if (distance(p, closest_point_on_segment(p, wall.a, wall.b)) > kTiny) continue;
      for (const Point end : {wall.a, wall.b}) {
        if (distance(p, end) > kTiny) result.push_back(bearing(end - p));
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(
        std::unique(result.begin(), result.end(), [](double a, double b) { return b - a < kTiny; }),
        result.end());
    return result;
  }

  bool is_free(Point p) const { return space_.is_free(p); }

  // The wedge on one side of the line through p along `direction`: no wall in it, and free?
  bool passes(Point p, double direction_rad, bool left) const {
    for (const double wall : wall_bearings(p)) {
      const double turn = turned(direction_rad, wall);
      if (turn < kTiny || std::abs(turn - std::numbers::pi) < kTiny) continue;
      if ((turn < std::numbers::pi) == left) return false;
    }
    const double beside = direction_rad + (left ? 0.5 : -0.5) * std::numbers::pi;
    return is_free(p + kStep_m * Point{std::cos(beside), std::sin(beside)});
  }

  // Distances from p along pq, without its ends, at which walls are met.
  std::vector<double> stops(Point p, Point q) const {
    const Point d = (1.0 / distance(p, q)) * (q - p);
    std::vector<double> result{0.0, distance(p, q)};
    const auto add = [&](double t) {
      if (t > kTiny && t < distance(p, q) - kTiny) result.push_back(t);
    };
    for (const auto& wall : walls_) {
      const double sa = cross(d, wall.a - p), sb = cross(d, wall.b - p);
      if (std::abs(sa) < kTiny) add(dot(d, wall.a - p));
      if (std::abs(sb) < kTiny) add(dot(d, wall.b - p));
      if (sa * sb < 0.0 && std::abs(sa) > kTiny && std::abs(sb) > kTiny) {
        add(dot(d, wall.a + (sa / (sa - sb)) * (wall.b - wall.a) - p));
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(
        std::unique(result.begin(), result.end(), [](double a, double b) { return b - a < kTiny; }),
        result.end());
    return result;
  }

  bool lies_on_wall(Point p) const {
    return std::any_of(walls_.begin(), walls_.end(), [&](const BlockingSegment& wall) {
      return distance(p, closest_point_on_segment(p, wall.a, wall.b)) < kTiny;
    });
  }

  // The sides on which a path that leaves p on `sides` arrives at q.
  Sides follow(Point p, Point q, Sides sides) const {
    const auto at = stops(p, q);
    const Point d = (1.0 / distance(p, q)) * (q - p);
    const Point n{-d.y, d.x};
    for (std::size_t i = 0; i + 1 < at.size() && sides.any(); ++i) {
      if (i > 0) {
        const Point x = p + at[i] * d;
        sides.left = sides.left && passes(x, bearing(d), true);
        sides.right = sides.right && passes(x, bearing(d), false);
      }
      const Point middle = p + 0.5 * (at[i] + at[i + 1]) * d;
      if (lies_on_wall(middle)) {
        sides.left = sides.left && is_free(middle + kStep_m * n);
        sides.right = sides.right && is_free(middle - kStep_m * n);
      } else if (!is_free(middle)) {
        return {false, false};
      } else if (sides.any()) {
        sides = {};
      }
    }
    return sides;
  }

  std::size_t sector_count(std::size_t corner) const {
    return std::max<std::size_t>(1, bearings_[corner].size());
  }

  // Sides of the direction that lie in the closed sector; sector k runs from wall k to wall k + 1.
  Sides sides_in(std::size_t corner, std::size_t sector, double direction_rad) const {
    const auto& walls = bearings_[corner];
    if (walls.empty()) return {};
    const double from = walls[sector], to = walls[(sector + 1) % walls.size()];
    const double width = walls.size() == 1 ? 2.0 * std::numbers::pi : turned(from, to);
    const double turn = turned(from, direction_rad);
    const bool at_from = turn < kTiny,
               at_to = walls.size() == 1 ? at_from : std::abs(turn - width) < kTiny;
    if (at_from || at_to) return {at_from, at_to};
    return {turn < width, turn < width};
  }

  // Free sectors only: a start in a solid leads nowhere.
  bool is_free_sector(std::size_t corner, std::size_t sector) const {
    const auto& walls = bearings_[corner];
    if (walls.empty()) return is_free(corners_[corner]);
    const double to = walls[(sector + 1) % walls.size()];
    const double width = walls.size() == 1 ? 2.0 * std::numbers::pi : turned(walls[sector], to);
    const double middle = walls[sector] + 0.5 * width;
    return is_free(corners_[corner] + kStep_m * Point{std::cos(middle), std::sin(middle)});
  }

  template <class Visit>
  void for_each_successor(State state, Visit visit) const {
    const Point p = corners_[state.corner];
    for (std::size_t next = 0; next < corners_.size(); ++next) {
      const Point q = corners_[next];
      if (next == state.corner || distance(p, q) < kTiny) continue;
      const Sides leaving = sides_in(state.corner, state.sector, bearing(q - p));
      if (!leaving.any()) continue;
      const Sides arriving = follow(p, q, leaving);
      if (!arriving.any()) continue;
      for (std::size_t sector = 0; sector < sector_count(next); ++sector) {
        // Seen from q back to p, left and right change places.
        const Sides back = sides_in(next, sector, bearing(p - q));
        if ((arriving.left && back.right) || (arriving.right && back.left)) {
          visit(State{next, sector}, distance(p, q));
        }
      }
    }
  }

  std::optional<double> dijkstra() const {
    std::vector<std::vector<double>> best;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      best.emplace_back(sector_count(i), HUGE_VAL);
    }
    using Entry = std::pair<double, std::pair<std::size_t, std::size_t>>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t sector = 0; sector < sector_count(0); ++sector) {
      if (!is_free_sector(0, sector)) continue;
      best[0][sector] = 0.0;
      queue.push({0.0, {0, sector}});
    }
    while (!queue.empty()) {
      const auto [length, place] = queue.top();
      queue.pop();
      if (place.first == 1) return length;
      if (length > best[place.first][place.second]) continue;
      for_each_successor({place.first, place.second}, [&](State next, double leg) {
        if (length + leg >= best[next.corner][next.sector]) return;
        best[next.corner][next.sector] = length + leg;
        queue.push({length + leg, {next.corner, next.sector}});
      });
    }
    return std::nullopt;
  }

  navcore::FreeSpace space_;
  std::vector<BlockingSegment> walls_;
  std::vector<Point> corners_;
  std::vector<std::vector<double>> bearings_;
};

}  // namespace

std::optional<double> slow_shortest_length_m(const Map& map, Point start, Point goal) {
  if (start == goal) return 0.0;
  return SlowPlanner(map).length_m(start, goal);
}

}  // namespace mapwright::test
