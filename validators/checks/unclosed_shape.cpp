#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_unclosed_shape(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    const auto& segments = obstacles[i].segments;
    if (!is_closed(obstacles[i].shape_type) || segments.empty()) continue;
    if (context.outline(i).closes || !context.is_complete(i)) continue;
    const Point end = segments.back().b;
    const Point start = segments.front().a;
    sink.segment(FindingCode::G105, i, segments.size() - 1, SegmentField::kBx, end,
                 name_of(obstacles[i]) + " is a closed shape but ends " +
                     metres(distance(end, start)) + " m from its beginning, at " + place_text(end) +
                     " and not at " + place_text(start) +
                     "; join the ends, or make it an open shape");
    sink.geometry() = geometry_of(segments);
    sink.geometry().points = {start, end};
  }
}

}  // namespace mapwright::validators
