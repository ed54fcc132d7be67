#include <unordered_map>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_duplicate_obstacle_id(const CheckContext& context, FindingSink& sink) {
  const auto& document = context.document();
  const auto& obstacles = context.map().obstacles;
  if (!context.survey().ids_may_repeat()) return;  // as convert writes them, and most people
  std::unordered_map<std::int64_t, std::size_t> first_with;
  first_with.reserve(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const auto [entry, is_new] = first_with.emplace(obstacles[i].id, i);
    if (is_new) continue;
    const auto place = document.index.place(document.text, entry->second, ObstacleField::kId);
    sink.obstacle(FindingCode::S101, i, ObstacleField::kId,
                  "the id " + std::to_string(obstacles[i].id) +
                      " is taken by the obstacle in line " + std::to_string(place.line) +
                      "; give this one another");
    append(sink.geometry(), geometry_of(obstacles[entry->second]));
  }
}

}  // namespace mapwright::validators
