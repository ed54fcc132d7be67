#include <string>
#include <string_view>
#include <unordered_map>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// On another floor a name may stand again.
std::string place_key(const Obstacle& obstacle, std::string_view name) {
  const auto level = obstacle.semantic.value(semantic_key::kLevel).value_or("");
  return std::string(name) + "," + std::string(level);
}

// The parts of one feature follow each other and say the same; its holes carry its name too.
bool is_part_of(const Obstacle& obstacle, const Obstacle& before) {
  return obstacle.semantic == before.semantic;
}

}  // namespace

void check_duplicate_name(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  std::unordered_map<std::string, std::size_t> first_of;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const auto name = obstacles[i].semantic.value(semantic_key::kName);
    if (!name || name->empty() || obstacles[i].semantic.value(semantic_key::kInnerOf)) continue;
    const auto [entry, is_new] = first_of.emplace(place_key(obstacles[i], *name), i);
    if (is_new || is_part_of(obstacles[i], obstacles[i - 1])) continue;
    const Obstacle& first = obstacles[entry->second];
    sink.obstacle(FindingCode::S125, i, ObstacleField::kSemantic,
                  name_of(obstacles[i]) + " has the name '" + std::string(*name) + "' of " +
                      name_of(first) + "; give one of them another");
    append(sink.geometry(), geometry_of(first));
  }
}

}  // namespace mapwright::validators
