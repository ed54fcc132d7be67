#include "validators/survey/survey.hpp"

#include <numeric>
#include <utility>

#include "validators/survey/surveyor.hpp"

namespace mapwright::validators {

Survey::Survey(const Map& map, const ValidationOptions& options, Proofs proofs) {
  Surveyor surveyor(options);
  surveyor.reserve(map.obstacles.size());
  for (const Obstacle& obstacle : map.obstacles) {
    surveyor.look_at(
        {0, obstacle.id, obstacle.shape_type, obstacle.semantic.view(), obstacle.segments});
  }
  *this = std::move(surveyor).survey();
  if (proofs == Proofs::kNone) doubt_everything(map);
}

void Survey::doubt_everything(const Map& map) {
  Positions all(map.obstacles.size());
  std::iota(all.begin(), all.end(), 0U);
  in_doubt_.fill(all);
  ids_may_repeat_ = names_may_repeat_ = true;
}

}  // namespace mapwright::validators
