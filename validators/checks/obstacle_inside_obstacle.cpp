#include <cstdint>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/shape/reach.hpp"
#include "validators/shape/solid.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

namespace {

void report(const CheckContext& context, std::size_t inner, std::size_t outer, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  sink.obstacle(FindingCode::G124, inner, ObstacleField::kKeyword,
                name_of(obstacles[inner]) + " lies wholly inside of " + name_of(obstacles[outer]) +
                    ", which is solid; remove it, or cut a courtyard around it");
  append(sink.geometry(), geometry_of(obstacles[outer]));
}

void check_solid(const CheckContext& context, std::uint32_t solid, FindingSink& sink) {
  const Region region = region_of(context, solid);
  for (const auto i : context.nesting().held(solid)) {
    const Body body = body_of(context, i);
    if (body != Body::kSolid && body != Body::kWall) continue;
    if (lies_wholly_inside(context, region, i, context.options().overlap_depth_m)) {
      report(context, i, solid, sink);
    }
  }
}

}  // namespace

// Of nested obstacles each is told of once, with the one right around it.
void check_obstacle_inside_obstacle(const CheckContext& context, FindingSink& sink) {
  for (const auto i : context.nesting().holders()) {
    if (body_of(context, i) == Body::kSolid) check_solid(context, i, sink);
  }
}

}  // namespace mapwright::validators
