#include <bit>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "mapcore/defect_geometry.hpp"
#include "mapcore/parts/piece_keys.hpp"
#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// On another floor a name may stand again.
struct NameOnLevel {
  std::string_view name, level;
  friend bool operator==(const NameOnLevel&, const NameOnLevel&) = default;
};

struct NameHash {
  std::size_t operator()(const NameOnLevel& name) const {
    const std::hash<std::string_view> hash;
    return hash(name.name) ^ std::rotl(hash(name.level), 31);
  }
};

// The parts of one feature follow each other and say the same; its holes carry its name too.
bool is_part_of(const Obstacle& obstacle, const Obstacle& before) {
  return obstacle.semantic == before.semantic;
}

}  // namespace

void check_duplicate_name(const CheckContext& context, FindingSink& sink) {
  if (!context.survey().names_may_repeat()) return;
  const auto& obstacles = context.map().obstacles;
  std::unordered_map<NameOnLevel, std::size_t, NameHash> first_of;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const auto& semantic = obstacles[i].semantic;
    const auto name = semantic.value(semantic_key::kName);
    if (!name || name->empty() || semantic.value(semantic_key::kInnerOf)) continue;
    if (semantic.value(piece_key::kPartOf)) continue;
    const auto level = semantic.value(semantic_key::kLevel).value_or("");
    const auto [entry, is_new] = first_of.emplace(NameOnLevel{*name, level}, i);
    if (is_new || is_part_of(obstacles[i], obstacles[i - 1])) continue;
    const Obstacle& first = obstacles[entry->second];
    sink.obstacle(FindingCode::S125, i, ObstacleField::kSemantic,
                  name_of(obstacles[i]) + " has the name '" + std::string(*name) + "' of " +
                      name_of(first) + "; give one of them another");
    append(sink.geometry(), geometry_of(first));
  }
}

}  // namespace mapwright::validators
