#include "mapcore/parts/crop.hpp"

#include <algorithm>
#include <cmath>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/parts/cut.hpp"
#include "mapcore/parts/families.hpp"
#include "mapcore/parts/sewing.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright {
namespace {

// Whether a segment has a point in a box (Liang and Barsky, 1984).
bool reaches_into(const Box& box, Point a, Point b) {
  double from = 0.0, to = 1.0;
  const auto clip = [&](double start, double step, double low, double high) {
    if (step == 0.0) return low <= start && start <= high;
    const double first = (low - start) / step, second = (high - start) / step;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
    return from <= to;
  };
  return clip(a.x, b.x - a.x, box.min_x, box.max_x) && clip(a.y, b.y - a.y, box.min_y, box.max_y);
}

bool is_solid_ring(const Obstacle& obstacle) {
  return is_closed(obstacle.shape_type) && obstacle.shape_type != ShapeType::kRamp &&
         obstacle.segments.size() >= 3;
}

// Which families belong to the part: those with a segment in the region, and solids around all of
// it.
class Selection {
 public:
  Selection(const Map& map, const CropRegion& region)
      : outline_(outline_of_each(map)), is_in_(map.obstacles.size()), wraps_(map.obstacles.size()) {
    const Point sample = region.center.value_or(Point{region.box.min_x, region.box.min_y});
    for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
      const auto& obstacle = map.obstacles[i];
      const std::size_t outline = outline_[i];
      for (const auto& s : obstacle.segments) {
        if (!region.touches(s.a, s.b)) continue;
        is_in_[outline] = true;
        break;
      }
      if (!is_in_[outline]) wraps_[outline] += turns_around(obstacle, sample);
    }
  }

  std::size_t outline(std::size_t i) const { return outline_[i]; }
  bool has(std::size_t i) const { return is_in_[outline_[i]] || wraps_[outline_[i]] > 0; }

 private:
  static int turns_around(const Obstacle& obstacle, Point p) {
    if (!is_solid_ring(obstacle) || !extent(obstacle).contains(p)) return 0;
    const auto ring = chain_points(obstacle);
    if (side_of_ring(ring, p) != PointSide::kInside) return 0;
    return ring_orientation(ring) == RingOrientation::kClockwise ? -1 : 1;
  }

  std::vector<std::size_t> outline_;
  std::vector<bool> is_in_;
  std::vector<int> wraps_;  // how often an outline and its holes go around the region
};

bool is_within(const Box& box, const Obstacle& obstacle) {
  return std::all_of(obstacle.segments.begin(), obstacle.segments.end(),
                     [&](const Segment& s) { return box.contains(s.a) && box.contains(s.b); });
}

void count_protruding(Crop& part) {
  for (const auto& obstacle : part.map.obstacles) {
    if (!is_within(part.map.border.box(), obstacle)) ++part.protruding;
  }
}

void keep_whole(const Map& map, const Selection& selection, Crop& part) {
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    if (selection.has(i))
      part.map.obstacles.push_back(map.obstacles[i]);
    else
      ++part.dropped;
  }
}

// Families that lie within the box stay as they are; the others are cut when their first member
// comes.
void keep_cut(const Map& map, const Selection& selection, const Box& box, double resolution_m,
              Crop& part) {
  std::vector<std::vector<std::size_t>> members(map.obstacles.size());
  std::vector<bool> is_across(map.obstacles.size());
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    auto& family = members[selection.outline(i)];
    family.insert(selection.outline(i) == i ? family.begin() : family.end(), i);
    if (!is_within(box, map.obstacles[i])) is_across[selection.outline(i)] = true;
  }
  Cutter cutter(map, box, resolution_m);
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const std::size_t outline = selection.outline(i);
    if (!selection.has(i)) {
      ++part.dropped;
    } else if (!is_across[outline]) {
      part.map.obstacles.push_back(map.obstacles[i]);
    } else if (!members[outline].empty()) {
      part.cut += cutter.cut(members[outline], part.map.obstacles);
      members[outline].clear();
    }
  }
}

// A map without pieces of obstacles in it.
Result<Crop> crop_whole(const Map& map, const CropRegion& region, const CropOptions& options) {
  const text::DecimalFormat format(options.resolution_m);
  const auto round = [&](double value) { return format.rounded(value); };
  Crop part;
  part.map.border = {round(std::max(region.box.min_x, map.border.left)),
                     round(std::min(region.box.max_y, map.border.top)),
                     round(std::min(region.box.max_x, map.border.right)),
                     round(std::max(region.box.min_y, map.border.bottom))};
  const Border& border = part.map.border;
  if (!(border.left < border.right && border.bottom < border.top)) {
    return usage_failure("the part has no area in common with the map's border");
  }
  const Selection selection(map, region);
  if (options.cut)
    keep_cut(map, selection, border.box(), options.resolution_m, part);
  else
    keep_whole(map, selection, part);
  count_protruding(part);
  return part;
}

}  // namespace

CropRegion CropRegion::of_disc(Point center, double radius_m) {
  const Box box{center.x - radius_m, center.y - radius_m, center.x + radius_m, center.y + radius_m};
  return {box, center, radius_m};
}

bool CropRegion::touches(Point a, Point b) const {
  if (!center) return reaches_into(box, a, b);
  return distance(closest_point_on_segment(*center, a, b), *center) <= radius_m;
}

Result<Crop> crop(const Map& map, const CropRegion& region, const CropOptions& options) {
  if (options.cut && region.center) {
    return usage_failure("only a box can cut obstacles: a disc's edge is no chain of segments");
  }
  if (has_pieces(map)) return crop_whole(sewn(map).map, region, options);
  return crop_whole(map, region, options);
}

}  // namespace mapwright
