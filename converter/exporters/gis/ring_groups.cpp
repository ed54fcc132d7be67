#include "converter/exporters/gis/ring_groups.hpp"

#include <charconv>
#include <cmath>
#include <unordered_map>

#include "converter/pipeline/ring_validity.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright::converter {
namespace {

bool is_joined(const std::vector<Segment>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::size_t next = i + 1 == segments.size() ? 0 : i + 1;
    if (segments[i].b != segments[next].a) return false;
  }
  return segments.size() >= 3;
}

bool is_ring(const Obstacle& obstacle) {
  return is_closed(obstacle.shape_type) && is_joined(obstacle.segments) &&
         is_simple_ring(chain_points(obstacle));
}

bool is_outline(const Obstacle& obstacle) {
  return obstacle.shape_type == ShapeType::kClosedPolygon ||
         obstacle.shape_type == ShapeType::kClosedCurve;
}

bool contains(const Box& outer, const Box& inner) {
  return outer.contains({inner.min_x, inner.min_y}) && outer.contains({inner.max_x, inner.max_y});
}

class Grouping {
 public:
  explicit Grouping(const Map& map) : map_(map), count_(map.obstacles.size()) {
    groups_.is_ring.resize(count_);
    groups_.outer_of.assign(count_, RingGroups::kNone);
    groups_.holes.resize(count_);
    orientations_.assign(count_, RingOrientation::kDegenerate);
    for (std::size_t i = 0; i < count_; ++i) {
      groups_.is_ring[i] = is_ring(map.obstacles[i]);
      if (groups_.is_ring[i]) orientations_[i] = ring_orientation(chain_points(map.obstacles[i]));
    }
  }

  RingGroups group(bool join_holes) {
    if (!join_holes) return std::move(groups_);
    tie_by_token();
    tie_by_nesting();
    for (std::size_t i = 0; i < count_; ++i) {
      if (groups_.outer_of[i] != RingGroups::kNone) groups_.holes[groups_.outer_of[i]].push_back(i);
    }
    for (std::size_t i = 0; i < count_; ++i) release_unsound(i);
    return std::move(groups_);
  }

 private:
  bool is_solid(std::size_t i) const {
    return is_outline(map_.obstacles[i]) && orientations_[i] == RingOrientation::kCounterClockwise;
  }
  bool is_inner(std::size_t i) const {
    return is_outline(map_.obstacles[i]) && orientations_[i] == RingOrientation::kClockwise;
  }

  void tie_by_token() {
    std::unordered_map<std::int64_t, std::size_t> solids;
    for (std::size_t i = 0; i < count_; ++i) {
      if (is_solid(i)) solids.try_emplace(map_.obstacles[i].id, i);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if (!is_inner(i)) continue;
      const auto token = map_.obstacles[i].semantic.value(semantic_key::kInnerOf);
      if (!token) continue;
      std::int64_t id = 0;
      const auto [end, error] = std::from_chars(token->data(), token->data() + token->size(), id);
      if (error != std::errc{} || end != token->data() + token->size()) continue;
      if (const auto found = solids.find(id); found != solids.end()) {
        groups_.outer_of[i] = found->second;
      }
    }
  }

  void tie_by_nesting() {
    std::vector<std::size_t> members;
    std::vector<Box> boxes;
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i) {
      const bool untied = is_inner(i) && groups_.outer_of[i] == RingGroups::kNone &&
                          !map_.obstacles[i].semantic.value(semantic_key::kInnerOf);
      any = any || untied;
      if (!untied && !is_solid(i)) continue;
      members.push_back(i);
      boxes.push_back(extent(map_.obstacles[i]));
    }
    if (!any) return;
    for_each_meeting_pair(boxes, [&](std::size_t p, std::size_t q) {
      consider(members[p], boxes[p], members[q], boxes[q]);
      consider(members[q], boxes[q], members[p], boxes[p]);
    });
  }

  void consider(std::size_t inner, const Box& inner_box, std::size_t outer, const Box& outer_box) {
    if (!is_inner(inner) || !is_solid(outer) || !contains(outer_box, inner_box)) return;
    const auto ring = chain_points(map_.obstacles[outer]);
    if (side_of_ring(ring, map_.obstacles[inner].segments.front().a) != PointSide::kInside) return;
    auto& tied = groups_.outer_of[inner];
    const double area = std::abs(signed_area_m2(ring));
    const bool smaller = tied == RingGroups::kNone || area < area_of(tied);
    if (smaller || (area == area_of(tied) && outer < tied)) tied = outer;
  }

  double area_of(std::size_t i) const {
    return std::abs(signed_area_m2(chain_points(map_.obstacles[i])));
  }

  void release_unsound(std::size_t outer) {
    auto& holes = groups_.holes[outer];
    if (holes.empty()) return;
    std::vector<std::vector<Point>> rings{chain_points(map_.obstacles[outer])};
    for (const std::size_t hole : holes) rings.push_back(chain_points(map_.obstacles[hole]));
    if (polygon_defect(rings).empty()) return;
    for (const std::size_t hole : holes) groups_.outer_of[hole] = RingGroups::kNone;
    holes.clear();
  }

  const Map& map_;
  std::size_t count_;
  std::vector<RingOrientation> orientations_;
  RingGroups groups_;
};

}  // namespace

RingGroups ring_groups(const Map& map, bool join_holes) {
  return Grouping(map).group(join_holes);
}

}  // namespace mapwright::converter
