#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_empty_semantic(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kWords)) {
    if (obstacles[i].semantic.view().find_first_not_of(" \t\r\n,") != std::string_view::npos) {
      continue;
    }
    sink.obstacle(FindingCode::S103, i, ObstacleField::kSemantic,
                  name_of(obstacles[i]) +
                      " does not say what it is; write labels such as building or column");
  }
}

}  // namespace mapwright::validators
