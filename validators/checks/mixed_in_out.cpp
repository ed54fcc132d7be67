#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

constexpr std::size_t kLeastCorners = 4;

// Position of the one segment that differs from all others, else size().
std::size_t odd_one(const Obstacle& ring) {
  std::size_t indoor = 0, last_indoor = 0, last_outdoor = 0;
  const std::size_t n = ring.segments.size();
  for (std::size_t k = 0; k < n; ++k) {
    const bool is_indoor = ring.segments[k].in_out == InOut::kIndoor;
    indoor += is_indoor ? 1 : 0;
    (is_indoor ? last_indoor : last_outdoor) = k;
  }
  if (indoor == 1) return last_indoor;
  return indoor + 1 == n ? last_outdoor : n;
}

}  // namespace

void check_mixed_in_out(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kMixedInOut)) {
    const Obstacle& obstacle = obstacles[i];
    if (!context.outline(i).is_ring || obstacle.segments.size() < kLeastCorners) continue;
    const std::size_t k = odd_one(obstacle);
    if (k == obstacle.segments.size()) continue;
    const bool is_indoor = obstacle.segments[k].in_out == InOut::kIndoor;
    sink.segment(FindingCode::S127, i, k, SegmentField::kInOut, obstacle.segments[k].a,
                 name_of(obstacle, k) + " is " + (is_indoor ? "indoor" : "outdoor") +
                     ", all others of the outline are not; correct its inOut if that is a slip");
  }
}

}  // namespace mapwright::validators
