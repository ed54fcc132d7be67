#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

std::string kind_of(const Obstacle& obstacle) {
  std::string kind;
  for (const auto label : obstacle.semantic.labels()) {
    kind += (kind.empty() ? "" : ",") + std::string(label);
  }
  return kind;
}

// A ray passes over what is not higher than the laser (docs/rays.md); stairs and ramps have heights
// of their own.
bool is_missed(const Obstacle& obstacle, const ValidationOptions& options) {
  if (obstacle.shape_type == ShapeType::kStairs || obstacle.shape_type == ShapeType::kRamp) {
    return false;
  }
  const double height_m = max_height_m(obstacle);
  return options.ground_clearance_m < height_m && height_m <= options.laser_height_m;
}

void report(const CheckContext& context, const std::string& kind,
            const std::vector<std::size_t>& missed, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  const Obstacle& first = obstacles[missed.front()];
  std::string message = name_of(first);
  if (!kind.empty()) message += " (" + kind + ")";
  if (missed.size() > 1)
    message += " and " + std::to_string(missed.size() - 1) + " more of its kind";
  message += missed.size() > 1 ? " are" : " is";
  message += " not higher than the laser (" + metres(context.options().laser_height_m) +
             " m): the robot runs into what it does not see; give it a lower sensor too";
  sink.obstacle(FindingCode::S121, missed.front(), ObstacleField::kKeyword, std::move(message));
  for (std::size_t n = 1; n < missed.size(); ++n) {
    append(sink.geometry(), geometry_of(obstacles[missed[n]]));
  }
}

}  // namespace

// A site has hundreds of kerbs and one laser: told once for each kind of obstacle, by its labels.
void check_below_laser(const CheckContext& context, FindingSink& sink) {
  std::map<std::string, std::vector<std::size_t>> missed_by_kind;
  std::unordered_map<const char*, std::vector<std::size_t>*> by_string;  // many share one
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kLow)) {
    if (!is_missed(obstacles[i], context.options())) continue;
    auto& missed = by_string[obstacles[i].semantic.view().data()];
    if (missed == nullptr) missed = &missed_by_kind[kind_of(obstacles[i])];
    missed->push_back(i);
  }
  for (const auto& [kind, missed] : missed_by_kind) report(context, kind, missed, sink);
}

}  // namespace mapwright::validators
