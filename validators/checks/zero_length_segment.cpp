#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_zero_length_segment(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kZeroLength)) {
    for (std::size_t k = 0; k < obstacles[i].segments.size(); ++k) {
      const Segment& segment = obstacles[i].segments[k];
      if (segment.a != segment.b) continue;
      sink.segment(FindingCode::G103, i, k,
                   name_of(obstacles[i], k) + " begins and ends at " + place_text(segment.a) +
                       "; remove it and count it off");
    }
  }
}

}  // namespace mapwright::validators
