#include "navcore/engine/cell_compiler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "navcore/engine/iso_line.hpp"
#include "navcore/engine/umbra.hpp"

namespace mapwright::navcore::engine {
namespace {

// Lists hold what lies this far (metres) beyond the range or the cell's edge, so that rounding
// decides nothing.
constexpr double kRangeMargin_m = 1e-3;
constexpr double kCellMargin_m = 1e-6;

// Occluders tried on each segment: those that look largest from the cell.
constexpr std::size_t kMostOccluders = 48;

enum class Role { kWall, kRamp, kStop, kLowStep, kTop };

struct Candidate {
  CellWall wall;
  Role role = Role::kWall;
  std::uint32_t obstacle = 0;  ///< of the scene; meaningless for ramps
};

struct Occluder {
  Umbra umbra;
  std::uint32_t item;
};

class Compilation {
 public:
  Compilation(const Scene& scene, const Reach& reach, Point center)
      : scene_(scene),
        reach_(reach),
        center_(center),
        square_{0.5 * reach.cell_size_m + kCellMargin_m},
        radius_m_(reach.max_range_m + square_.half_m * std::numbers::sqrt2 + kRangeMargin_m) {}

  CellWalls run() {
    gather();
    add_occluders();
    std::erase_if(candidates_, [&](const Candidate& c) { return is_hidden(c); });
    return sorted_by_role();
  }

 private:
  // -- gathering ------------------------------------------------------------------------------

  void gather() {
    std::vector<std::uint32_t> items;
    const double r = radius_m_;
    scene_.bins().visit({center_.x - r, center_.y - r, center_.x + r, center_.y + r},
                        [&](std::uint32_t item) { items.push_back(item); });
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    for (const std::uint32_t item : items) {
      if (scene_.is_ramp(item)) {
        add_ramp(item);
      } else {
        add_segment(item);
      }
    }
  }

  void add_ramp(std::uint32_t item) {
    for (const OneSidedSegment& line : iso_lines(scene_.ramp(item), reach_.height_m)) {
      const Point a = line.a - center_;
      const Point b = line.b - center_;
      if (square_.side(a, b) == Square::Side::kRight) continue;
      add(a, b, item, Role::kRamp, 0);
    }
  }

  void add_segment(std::uint32_t item) {
    const SceneSegment& segment = scene_.segments()[item];
    const std::uint32_t obstacle = scene_.obstacle_of(item);
    const bool stairs = scene_.obstacles()[obstacle].stairs;
    const bool stops = segment.height_m > reach_.height_m;
    if (!stops && !stairs) return;
    const Role low = segment.height_m > 0.0 ? Role::kLowStep : Role::kTop;
    const Role role = stairs ? (stops ? Role::kStop : low) : Role::kWall;
    add(segment.a - center_, segment.b - center_, item, role, obstacle);
  }

  void add(Point a, Point b, std::uint32_t item, Role role, std::uint32_t obstacle) {
    if (const auto part = clipped_to_circle(a, b, radius_m_)) {
      candidates_.push_back({{part->a, part->b, item}, role, obstacle});
    }
  }

  // -- what hides -----------------------------------------------------------------------------

  void add_occluders() {
    std::vector<Umbra> chords;
    for (std::size_t i = 0; i < candidates_.size();) {
      const std::size_t end = end_of_obstacle(i);
      add_occluders({candidates_.data() + i, end - i}, chords);
      i = end;
    }
    for (const Umbra& umbra : chords) everything_.push_back({umbra, kNoItem});
    keep_largest(everything_);
    drop_far_sides();
  }

  std::size_t end_of_obstacle(std::size_t i) const {
    std::size_t end = i + 1;
    while (end < candidates_.size() && candidates_[end].role == candidates_[i].role &&
           candidates_[end].obstacle == candidates_[i].obstacle) {
      ++end;
    }
    return end;
  }

  void add_occluders(std::span<const Candidate> run, std::vector<Umbra>& chords) {
    for (const Candidate& c : run) {
      const auto umbra = Umbra::of(c.wall.a, c.wall.b, square_);
      if (!umbra) continue;
      if (c.role == Role::kWall || c.role == Role::kRamp) {
        everything_.push_back({*umbra, c.wall.item});
      } else {
        own_stairs_.push_back({*umbra, c.wall.item});
      }
    }
    if (run.front().role == Role::kWall) add_chords(run, chords);
  }

  // Chains of consecutive walls, with their true ends.
  void add_chords(std::span<const Candidate> run, std::vector<Umbra>& chords) const {
    std::vector<Point> chain;
    for (const Candidate& c : run) {
      const SceneSegment& segment = scene_.segments()[c.wall.item];
      const Point a = segment.a - center_;
      if (!chain.empty() && chain.back() != a) {
        add_chord_umbras(chain, square_, chords);
        chain.clear();
      }
      if (chain.empty()) chain.push_back(a);
      chain.push_back(segment.b - center_);
    }
    add_chord_umbras(chain, square_, chords);
  }

  static void keep_largest(std::vector<Occluder>& occluders) {
    std::stable_sort(occluders.begin(), occluders.end(), [](const Occluder& p, const Occluder& q) {
      return p.umbra.apparent_size() > q.umbra.apparent_size();
    });
    if (occluders.size() > kMostOccluders) {
      occluders.erase(occluders.begin() + kMostOccluders, occluders.end());
    }
  }

  // -- far sides of rings ---------------------------------------------------------------------

  void drop_far_sides() {
    for (std::size_t i = 0; i < candidates_.size();) {
      const std::size_t end = end_of_obstacle(i);
      if (candidates_[i].role == Role::kWall) {
        mark_far_sides(scene_.obstacles()[candidates_[i].obstacle],
                       {candidates_.data() + i, end - i});
      }
      i = end;
    }
    std::erase_if(candidates_, [](const Candidate& c) { return c.wall.item == kNoItem; });
  }

  void mark_far_sides(const SceneObstacle& ring, std::span<Candidate> run) const {
    if (!ring.simple_ring || !(ring.min_height_m > reach_.height_m)) return;
    const auto inside = is_inside(ring);
    if (!inside) return;
    // Of the side that the cell is not on.
    const Square::Side far =
        ring.counter_clockwise != *inside ? Square::Side::kLeft : Square::Side::kRight;
    for (Candidate& c : run) {
      const SceneSegment& segment = scene_.segments()[c.wall.item];
      if (square_.side(segment.a - center_, segment.b - center_) == far) c.wall.item = kNoItem;
    }
  }

  // Whether the cell lies within the ring; nothing where the ring runs through it.
  std::optional<bool> is_inside(const SceneObstacle& ring) const {
    const Point low = Point{ring.box.min_x, ring.box.min_y} - center_;
    const Point high = Point{ring.box.max_x, ring.box.max_y} - center_;
    const double h = square_.half_m;
    if (low.x > h || low.y > h || high.x < -h || high.y < -h) return false;
    bool inside = false;
    for (const SceneSegment& segment : scene_.segments_of(ring)) {
      const Point p = segment.a - center_;
      const Point q = segment.b - center_;
      if (square_.meets(p, q)) return std::nullopt;
      if ((p.y > 0.0) != (q.y > 0.0) && (cross(p, q) > 0.0) == (q.y > p.y)) inside = !inside;
    }
    return inside;
  }

  // -- what is hidden -------------------------------------------------------------------------

  bool is_hidden(const Candidate& c) const {
    for (const Occluder& o : everything_) {
      if (o.item != c.wall.item && o.umbra.hides(c.wall.a, c.wall.b)) return true;
    }
    return is_stairs(c) && is_hidden_by_own_stairs(c);
  }

  static bool is_stairs(const Candidate& c) {
    return c.role != Role::kWall && c.role != Role::kRamp;
  }

  // A top or a low step matters only where it is what a ray meets first of its staircase; a step
  // that stops the ray also where others come before.
  bool is_hidden_by_own_stairs(const Candidate& c) const {
    return std::any_of(own_stairs_.begin(), own_stairs_.end(), [&](const Occluder& o) {
      if (o.item == c.wall.item || scene_.obstacle_of(o.item) != c.obstacle) return false;
      if (c.role == Role::kStop && !(scene_.segments()[o.item].height_m > reach_.height_m)) {
        return false;
      }
      return o.umbra.hides(c.wall.a, c.wall.b);
    });
  }

  // -- result ---------------------------------------------------------------------------------

  CellWalls sorted_by_role() const {
    CellWalls walls;
    for (std::size_t i = 0; i < candidates_.size();) {
      if (is_stairs(candidates_[i])) {
        add_stairs(i, walls);
        continue;
      }
      const Candidate& c = candidates_[i++];
      (c.role == Role::kRamp ? walls.one_sided : walls.two_sided).push_back(c.wall);
    }
    return walls;
  }

  // Where no top can be met first, the steps that stop rays are walls like others.
  void add_stairs(std::size_t& i, CellWalls& walls) const {
    CellStairs stairs;
    const std::uint32_t obstacle = candidates_[i].obstacle;
    for (;
         i < candidates_.size() && is_stairs(candidates_[i]) && candidates_[i].obstacle == obstacle;
         ++i) {
      const Candidate& c = candidates_[i];
      (c.role == Role::kStop      ? stairs.stops
       : c.role == Role::kLowStep ? stairs.low_steps
                                  : stairs.tops)
          .push_back(c.wall);
    }
    drop_tops_behind_stops(stairs);
    drop_low_steps_behind_tops(stairs);
    drop_stops_behind_tops(stairs);
    if (stairs.tops.empty()) {
      walls.two_sided.insert(walls.two_sided.end(), stairs.stops.begin(), stairs.stops.end());
    } else if (!stairs.stops.empty()) {
      walls.stairs.push_back(std::move(stairs));
    }
  }

  // A top matters where a ray meets it before a stop, so not where all stops lie on the cell's side
  // of its line: the robot is downstairs.
  void drop_tops_behind_stops(CellStairs& stairs) const {
    std::erase_if(stairs.tops,
                  [&](const CellWall& top) { return are_all_before(stairs.stops, top); });
  }

  // A low step matters where a ray meets it before a top, so not where all tops lie on the cell's
  // side of its line: the robot is upstairs.
  void drop_low_steps_behind_tops(CellStairs& stairs) const {
    std::erase_if(stairs.low_steps,
                  [&](const CellWall& step) { return are_all_before(stairs.tops, step); });
  }

  // True if no ray from the cell meets one of the walls beyond the line.
  bool are_all_before(const std::vector<CellWall>& walls, const CellWall& line) const {
    const Square::Side near = square_.side(line.a, line.b);
    if (near == Square::Side::kBoth) return false;
    const double sign = near == Square::Side::kLeft ? 1.0 : -1.0;
    return std::all_of(walls.begin(), walls.end(), [&](const CellWall& wall) {
      return sign * side_of_line(line.a, line.b, wall.a) >= 0.0 &&
             sign * side_of_line(line.a, line.b, wall.b) >= 0.0;
    });
  }

  // Where no low step can be met first, a ray that meets a top before a stop meets the top first of
  // all and crosses the staircase, or another stop before.
  void drop_stops_behind_tops(CellStairs& stairs) const {
    if (!stairs.low_steps.empty()) return;
    std::erase_if(stairs.stops, [&](const CellWall& stop) {
      return std::any_of(stairs.tops.begin(), stairs.tops.end(), [&](const CellWall& top) {
        const auto umbra = Umbra::of(top.a, top.b, square_);
        return umbra && umbra->hides(stop.a, stop.b);
      });
    });
  }

  static constexpr std::uint32_t kNoItem = UINT32_MAX;

  const Scene& scene_;
  const Reach& reach_;
  const Point center_;
  const Square square_;
  const double radius_m_;
  std::vector<Candidate> candidates_;
  std::vector<Occluder> everything_;  ///< what stops every ray from the cell
  std::vector<Occluder> own_stairs_;  ///< steps and tops: matter within their staircase
};

}  // namespace

CellWalls compile_cell(const Scene& scene, const Reach& reach, Point center) {
  return Compilation(scene, reach, center).run();
}

}  // namespace mapwright::navcore::engine
