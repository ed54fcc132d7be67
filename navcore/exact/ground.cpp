#include "navcore/exact/ground.hpp"

#include <algorithm>
#include <cmath>

#include "navcore/exact/free_faces.hpp"

namespace mapwright::navcore::exact {
namespace {

std::optional<Failure> why_not(const Border& border) {
  const bool finite =
      is_finite({border.left, border.top}) && is_finite({border.right, border.bottom});
  if (!finite || border.right - border.left < 1e-3 || border.top - border.bottom < 1e-3) {
    return Failure{FailureKind::kInput,
                   "the map's border has no area: its corners must be top-left and bottom-right"};
  }
  return std::nullopt;
}

Point centre(const Border& border) {
  return {0.5 * (border.left + border.right), 0.5 * (border.top + border.bottom)};
}

std::optional<Failure> why_not_on_grid(const Map& map, const std::vector<BlockingSegment>& segments,
                                       const GridFrame& frame) {
  const auto too_far = [&](const BlockingSegment& segment) {
    return !frame.can_hold(segment.a) || !frame.can_hold(segment.b);
  };
  if (!frame.can_hold({map.border.left, map.border.top})) {
    return Failure{FailureKind::kInput, "the map is wider than 1000 km"};
  }
  const auto far = std::find_if(segments.begin(), segments.end(), too_far);
  if (far == segments.end()) return std::nullopt;
  return Failure{FailureKind::kInput, "obstacle " +
                                          std::to_string(map.obstacles[far->obstacle].id) +
                                          " lies more than 500 km from the centre of the map"};
}

// The end of a segment that rounding to the grid moves farthest, and how far.
struct Rounding {
  double moved_m = 0.0;
  Point at;
};

Rounding worst_rounding(const std::vector<BlockingSegment>& segments, const GridFrame& frame) {
  Rounding worst;
  for (const auto& segment : segments) {
    for (const Point end : {segment.a, segment.b}) {
      const double moved_m = distance(end, frame.to_map(frame.to_grid(end)));
      if (moved_m > worst.moved_m) worst = {moved_m, end};
    }
  }
  // What is left of decimals in doubles is no error.
  return worst.moved_m > 1e-7 ? worst : Rounding{};
}

}  // namespace

Result<std::shared_ptr<const Ground>> Ground::build(const Map& map, RampPolicy ramps) {
  if (auto failure = why_not(map.border)) return tl::unexpected(std::move(*failure));
  auto ground = std::make_shared<Ground>();
  ground->border = map.border;
  ground->frame = GridFrame(centre(map.border));
  ground->segments = blocking_segments(map, ramps);
  if (auto failure = why_not_on_grid(map, ground->segments, ground->frame)) {
    return tl::unexpected(std::move(*failure));
  }
  ground->space = std::make_shared<const Tessellation>(
      tessellate(map, ramps, ground->frame, map_lines(map, ground->segments, ground->frame)));
  const Rounding rounding = worst_rounding(ground->segments, ground->frame);
  const LineWork& work = ground->space->work;
  ground->snapping_mm = 1e3 * rounding.moved_m + work.displacement_mm;
  ground->snapped_at = rounding.at;
  if (!(rounding.moved_m > 0.0) && work.displaced_at) {
    ground->snapped_at = ground->frame.to_map(*work.displaced_at);
  }
  return ground;
}

const Widths& Ground::widths() const {
  std::call_once(widths_built_, [&] { widths_.emplace(*space); });
  return *widths_;
}

const SegmentIndex& Ground::index() const {
  std::call_once(index_built_, [&] {
    std::vector<IndexedSegment> indexed;
    indexed.reserve(segments.size());
    for (const auto& segment : segments) indexed.push_back({segment.a, segment.b, 0});
    index_.emplace(std::move(indexed));
  });
  return *index_;
}

}  // namespace mapwright::navcore::exact
