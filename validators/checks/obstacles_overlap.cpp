#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/shape/reach.hpp"
#include "validators/shape/solid.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// What counts as overlapping: docs/decisions/0011-overlapping-obstacles.md.

class Overlaps {
 public:
  Overlaps(const CheckContext& context, FindingSink& sink)
      : context_(context),
        obstacles_(context.map().obstacles),
        depth_m_(context.options().overlap_depth_m),
        sink_(sink) {}

  void check(ObstaclePair pair) {
    const Body first = body(pair.first), second = body(pair.second);
    if (first == Body::kSolid || second == Body::kSolid) {
      if (is_solid_or_wall(first) && is_solid_or_wall(second)) check_solid(pair);
    }
    if (is_crossing_candidate(pair)) check_crossing(pair);
  }

 private:
  static bool is_solid_or_wall(Body body) { return body == Body::kSolid || body == Body::kWall; }
  static bool is_hollow(Body body) { return body == Body::kHole || body == Body::kRoom; }

  // Rooms against all else, and courtyards against their own building and its other courtyards.
  // What else a courtyard meets, it meets as a part of its building.
  bool is_crossing_candidate(ObstaclePair pair) {
    const Body first = body(pair.first), second = body(pair.second);
    if (first == Body::kNone || second == Body::kNone) return false;
    if (first == Body::kRoom || second == Body::kRoom) {
      return first != Body::kHole && second != Body::kHole;
    }
    const auto& nesting = context_.nesting();
    if (first == Body::kHole && second == Body::kHole) {
      return nesting.holder(pair.first) == nesting.holder(pair.second);
    }
    return (first == Body::kHole && nesting.holder(pair.first) == pair.second) ||
           (second == Body::kHole && nesting.holder(pair.second) == pair.first);
  }

  void check_solid(ObstaclePair pair) {
    const auto [first, second] = pair;
    if (is_wholly_inside(second, first) || is_wholly_inside(first, second)) return;
    if (body(first) == Body::kSolid) {
      if (const auto reach = reach_into(context_, region(first), second, depth_m_)) {
        return report(second, first, *reach);
      }
    }
    if (body(second) != Body::kSolid) return;
    if (const auto reach = reach_into(context_, region(second), first, depth_m_)) {
      return report_reached(second, first, *reach);
    }
    if (body(first) == Body::kSolid && is_same_ground(first, second)) {
      sink_.obstacle(FindingCode::G108, second, ObstacleField::kKeyword,
                     name_of(obstacles_[second]) + " covers the same ground as " +
                         name_of(obstacles_[first]) + "; remove one of them");
      append(sink_.geometry(), geometry_of(obstacles_[first]));
    }
  }

  // G124 tells of those.
  bool is_wholly_inside(std::uint32_t obstacle, std::uint32_t solid) {
    return body(solid) == Body::kSolid && holds(context_, solid, obstacle) &&
           lies_wholly_inside(context_, region(solid), obstacle, depth_m_);
  }

  // A hollow ring and an obstacle that lies neither inside nor outside of it as a whole.
  void check_crossing(ObstaclePair pair) {
    const bool first_is_ring = is_hollow(body(pair.first));
    const std::uint32_t ring = first_is_ring ? pair.first : pair.second;
    const std::uint32_t other = first_is_ring ? pair.second : pair.first;
    const auto reach = reach_across(context_, ring, other, depth_m_);
    if (!reach) return;
    first_is_ring ? report(pair.second, pair.first, *reach)
                  : report_reached(pair.second, pair.first, *reach);
  }

  Body body(std::uint32_t i) {
    const auto found = bodies_.find(i);
    if (found != bodies_.end()) return found->second;
    return bodies_.emplace(i, body_of(context_, i)).first->second;
  }

  const Region& region(std::uint32_t solid) {
    const auto found = regions_.find(solid);
    if (found != regions_.end()) return found->second;
    return regions_.emplace(solid, region_of(context_, solid)).first->second;
  }

  bool is_same_ground(std::uint32_t first, std::uint32_t second) {
    return region(first).holds(point_inside(obstacles_[second]), depth_m_) &&
           region(second).holds(point_inside(obstacles_[first]), depth_m_);
  }

  // The later obstacle, which is blamed, reaches into the earlier one.
  void report(std::uint32_t blamed, std::uint32_t other, const Reach& reach) {
    const std::string subject = name_of(obstacles_[blamed], reach.segment);
    const auto& cut = reach.piece.begins_at;
    const std::string message = cut ? subject + " crosses " +
                                          name_of(obstacles_[cut->obstacle], cut->edge) + " at " +
                                          place_text(reach.piece.from)
                                    : subject + " lies inside of " + name_of(obstacles_[other]) +
                                          " at " + place_text(reach.piece.from);
    sink_.segment(FindingCode::G108, blamed, reach.segment, SegmentField::kAx, reach.piece.from,
                  message + std::string(kAdvice));
    show(reach.piece.from, obstacles_[blamed].segments[reach.segment], cut);
  }

  // The earlier obstacle reaches into the later one, which is blamed.
  void report_reached(std::uint32_t blamed, std::uint32_t other, const Reach& reach) {
    const std::string subject = name_of(obstacles_[other], reach.segment);
    const auto& cut = reach.piece.begins_at ? reach.piece.begins_at : reach.piece.ends_at;
    if (!cut) {
      sink_.obstacle(FindingCode::G108, blamed, ObstacleField::kKeyword,
                     name_of(obstacles_[blamed]) + " lies around " + subject + " at " +
                         place_text(reach.piece.from) + std::string(kAdvice));
      append(sink_.geometry(), geometry_of(obstacles_[other].segments[reach.segment]));
      return;
    }
    sink_.segment(FindingCode::G108, cut->obstacle, cut->edge, SegmentField::kAx, cut->at,
                  name_of(obstacles_[cut->obstacle], cut->edge) + " crosses " + subject + " at " +
                      place_text(cut->at) + std::string(kAdvice));
    show(cut->at, obstacles_[other].segments[reach.segment], cut);
  }

  // A segment, and the edge it crosses.
  void show(Point at, const Segment& segment, const std::optional<Cut>& cut) {
    sink_.geometry() = {{at}, {{segment.a, segment.b}}, {}};
    if (cut) append(sink_.geometry(), geometry_of(obstacles_[cut->obstacle].segments[cut->edge]));
  }

  static constexpr std::string_view kAdvice = "; move one of them, or make one obstacle of both";

  const CheckContext& context_;
  const std::vector<Obstacle>& obstacles_;
  double depth_m_;
  std::unordered_map<std::uint32_t, Body> bodies_;
  FindingSink& sink_;
  std::map<std::uint32_t, Region> regions_;
};

}  // namespace

void check_obstacles_overlap(const CheckContext& context, FindingSink& sink) {
  Overlaps overlaps(context, sink);
  for (const auto pair : context.meeting_pairs()) overlaps.check(pair);
}

}  // namespace mapwright::validators
