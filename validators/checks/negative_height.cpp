#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_negative_height(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kHeights)) {
    for (std::size_t k = 0; k < obstacles[i].segments.size(); ++k) {
      const Segment& segment = obstacles[i].segments[k];
      if (segment.height_m >= 0.0) continue;
      sink.segment(FindingCode::S106, i, k, SegmentField::kHeight, segment.a,
                   name_of(obstacles[i], k) + " is " + metres(segment.height_m) +
                       " m high; heights count upwards from the ground beside the segment");
    }
  }
}

}  // namespace mapwright::validators
