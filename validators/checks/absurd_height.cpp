#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_absurd_height(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  const double limit_m = context.options().max_height_m;
  for (const auto i : context.in_doubt(Doubt::kHeights)) {
    for (std::size_t k = 0; k < obstacles[i].segments.size(); ++k) {
      const Segment& segment = obstacles[i].segments[k];
      if (segment.height_m <= limit_m) continue;
      sink.segment(FindingCode::S107, i, k, SegmentField::kHeight, segment.a,
                   name_of(obstacles[i], k) + " is " + metres(segment.height_m) +
                       " m high, more than " + metres(limit_m) +
                       " m; heights are metres, not millimetres");
    }
  }
}

}  // namespace mapwright::validators
