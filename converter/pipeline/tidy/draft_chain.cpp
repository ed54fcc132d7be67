#include "converter/pipeline/tidy/draft_chain.hpp"

#include <algorithm>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/ring_repair.hpp"

namespace mapwright::converter {
namespace {

bool have_one_style(const std::vector<Segment>& segments) {
  const Segment& first = segments.front();
  return std::all_of(segments.begin(), segments.end(), [&](const Segment& s) {
    return s.height_m == first.height_m && s.in_out == first.in_out && s.semantic == first.semantic;
  });
}

}  // namespace

std::optional<DraftChain> chain_of_draft(const Draft& draft) {
  const auto& obstacle = draft.obstacle;
  const bool is_chain =
      obstacle.shape_type != ShapeType::kStairs && obstacle.shape_type != ShapeType::kRamp;
  if (!is_chain || obstacle.segments.empty() || !have_one_style(obstacle.segments)) {
    return std::nullopt;
  }
  const Segment& first = obstacle.segments.front();
  DraftChain chain;
  chain.points = chain_points(obstacle);
  chain.closed = is_closed(obstacle.shape_type);
  chain.style = {first.height_m, first.in_out, first.semantic};
  return chain;
}

bool is_sound(const DraftChain& chain) {
  if (chain.closed) return is_simple_ring(chain.points);
  return chain.points.size() >= 2 && is_simple_chain(chain.points);
}

void set_chain(const DraftChain& chain, Draft& draft) {
  draft.obstacle.segments = chain_of(chain.points, chain.closed, chain.style);
}

}  // namespace mapwright::converter
