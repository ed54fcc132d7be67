#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_ramp_height_not_zero(const CheckContext& context, FindingSink& sink) {
  for_each_ramp(context, [&](const Obstacle& ramp, std::size_t i) {
    for (std::size_t k = 0; k < ramp.segments.size(); ++k) {
      const Segment& segment = ramp.segments[k];
      if (!(segment.height_m > 0.0)) continue;
      sink.segment(FindingCode::T203, i, k, SegmentField::kHeight, segment.a,
                   name_of(ramp, k) + " is " + metres(segment.height_m) +
                       " m high, but the footprint of a ramp has height 0; its normal says how "
                       "high it climbs");
    }
  });
}

}  // namespace mapwright::validators
