#include "navcore/space/solid_rings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

#include "mapcore/geometry/orientation.hpp"
#include "navcore/space/stairs_outline.hpp"

namespace mapwright::navcore {
namespace {

bool is_joined_ring(const Obstacle& obstacle) {
  const auto& segments = obstacle.segments;
  if (segments.size() < 3) return false;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].b != segments[(i + 1) % segments.size()].a || !is_finite(segments[i].a)) {
      return false;
    }
  }
  return true;
}

bool is_high_all_around(const Obstacle& obstacle) {
  return std::all_of(obstacle.segments.begin(), obstacle.segments.end(),
                     [](const Segment& segment) { return segment.height_m > 0.0; });
}

bool is_finite_ring(const RingPoints& ring) {
  return std::all_of(ring.begin(), ring.end(), [](Point p) { return is_finite(p); });
}

// The ring of an obstacle with a solid side; empty for all others.
RingPoints solid_sided_ring(const Obstacle& obstacle, RampPolicy ramps) {
  if (obstacle.shape_type == ShapeType::kStairs) {
    RingPoints outline = stairs_outline(obstacle);
    return is_finite_ring(outline) ? outline : RingPoints{};
  }
  const bool counts = obstacle.shape_type == ShapeType::kRamp
                          ? ramps == RampPolicy::kAvoid
                          : is_closed(obstacle.shape_type) && is_high_all_around(obstacle);
  return counts && is_joined_ring(obstacle) ? chain_points(obstacle) : RingPoints{};
}

std::optional<std::int64_t> inner_of(const Obstacle& obstacle) {
  const auto text = obstacle.semantic.value(semantic_key::kInnerOf);
  if (!text) return std::nullopt;
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), id);
  if (error != std::errc{} || end != text->data() + text->size()) return std::nullopt;
  return id;
}

void insert_sorted(std::vector<std::uint32_t>& numbers, std::uint32_t number) {
  const auto place = std::lower_bound(numbers.begin(), numbers.end(), number);
  if (place == numbers.end() || *place != number) numbers.insert(place, number);
}

}  // namespace

SolidRings::SolidRings(const Map& map, RampPolicy ramps) {
  std::vector<RingPoints> points;
  collect(map, ramps, points);
  locator_.emplace(points);
  const bool any_hollow = std::any_of(rings_.begin(), rings_.end(), [](const Ring& ring) {
    return ring.kind == Kind::kHollow;
  });
  if (!any_hollow) return;  // nothing takes away from a solid ring
  nest(points);
  tie_inner_rings(map);
  const auto is_outermost = [](const Ring& ring) { return ring.within.empty(); };
  const bool has_hollow = std::any_of(rings_.begin(), rings_.end(), [&](const Ring& ring) {
    return ring.kind == Kind::kHollow && is_outermost(ring);
  });
  const bool has_free_standing = std::any_of(rings_.begin(), rings_.end(), [&](const Ring& ring) {
    return ring.kind == Kind::kSolid && is_outermost(ring) && !ring.reaches_into_hollow;
  });
  drawn_from_inside_ = has_hollow && !has_free_standing;
}

void SolidRings::collect(const Map& map, RampPolicy ramps, std::vector<RingPoints>& points) {
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const Obstacle& obstacle = map.obstacles[i];
    RingPoints ring = solid_sided_ring(obstacle, ramps);
    if (ring.empty()) continue;
    const auto orientation = ring_orientation(ring);
    if (orientation == RingOrientation::kDegenerate) continue;
    Ring entry;
    entry.obstacle = static_cast<std::uint32_t>(i);
    if (obstacle.shape_type == ShapeType::kStairs || obstacle.shape_type == ShapeType::kRamp) {
      entry.kind = Kind::kFootprint;
    } else if (orientation == RingOrientation::kClockwise) {
      entry.kind = Kind::kHollow;
    }
    entry.area_m2 = std::abs(signed_area_m2(ring));
    rings_.push_back(std::move(entry));
    points.push_back(std::move(ring));
  }
}

// A ring lies within another when the other holds all its vertices. Of two equal rings the later
// one lies within the earlier.
void SolidRings::nest(const std::vector<RingPoints>& points) {
  for (std::uint32_t i = 0; i < rings_.size(); ++i) {
    std::unordered_map<std::uint32_t, std::size_t> held;
    for (const Point p : points[i]) {
      for (const auto holder : locator_->holders(p)) {
        ++held[holder.ring];
        rings_[i].reaches_into_hollow |=
            holder.ring != i && rings_[holder.ring].kind == Kind::kHollow && !holder.on_boundary;
      }
    }
    for (const auto& [other, count] : held) {
      const bool larger = rings_[other].area_m2 > rings_[i].area_m2 ||
                          (rings_[other].area_m2 == rings_[i].area_m2 && other < i);
      if (count == points[i].size() && larger) insert_sorted(rings_[i].within, other);
    }
  }
}

// The token inner_of ties a courtyard to its outline even where rounding has moved a vertex of the
// one across the other.
void SolidRings::tie_inner_rings(const Map& map) {
  std::unordered_map<std::int64_t, std::uint32_t> ring_by_id;
  for (std::uint32_t i = 0; i < rings_.size(); ++i) {
    if (rings_[i].kind == Kind::kSolid) ring_by_id.emplace(map.obstacles[rings_[i].obstacle].id, i);
  }
  for (auto& ring : rings_) {
    if (ring.kind != Kind::kHollow) continue;
    const auto id = inner_of(map.obstacles[ring.obstacle]);
    if (!id) continue;
    const auto outer = ring_by_id.find(*id);
    if (outer != ring_by_id.end()) insert_sorted(ring.within, outer->second);
  }
}

bool SolidRings::is_hollowed_out(std::uint32_t solid,
                                 const std::vector<RingLocator::Holder>& holders) const {
  return std::any_of(holders.begin(), holders.end(), [&](const RingLocator::Holder& holder) {
    const Ring& ring = rings_[holder.ring];
    return ring.kind == Kind::kHollow &&
           std::binary_search(ring.within.begin(), ring.within.end(), solid);
  });
}

std::optional<std::size_t> SolidRings::solid_at(Point p) const {
  const auto holders = locator_->holders(p);
  const Ring* smallest = nullptr;
  bool held_by_hollow = false;
  for (const auto& holder : holders) {
    const Ring& ring = rings_[holder.ring];
    if (ring.kind == Kind::kHollow) {
      held_by_hollow = true;
      continue;
    }
    if (holder.on_boundary || is_hollowed_out(holder.ring, holders)) continue;
    if (smallest == nullptr || ring.area_m2 < smallest->area_m2) smallest = &ring;
  }
  if (smallest != nullptr) return smallest->obstacle;
  if (drawn_from_inside_ && !held_by_hollow) return kOutside;
  return std::nullopt;
}

}  // namespace mapwright::navcore
