#include <optional>

#include "validators/characters.hpp"
#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

std::string complaint(const std::string& subject, const std::string& defect) {
  return "the semantic string of " + subject + " holds " + defect;
}

// Segments of an obstacle mostly share one string: looked at once.
void check_segments(const Obstacle& obstacle, std::size_t i, FindingSink& sink) {
  const char* last_text = nullptr;
  std::optional<std::string> defect;
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const auto text = obstacle.segments[k].semantic.view();
    if (text.data() != last_text) {
      last_text = text.data();
      defect = unreadable_part(text);
    }
    if (!defect) continue;
    sink.segment(FindingCode::S104, i, k, SegmentField::kSemantic, obstacle.segments[k].a,
                 complaint(name_of(obstacle, k), *defect));
  }
}

}  // namespace

void check_unreadable_semantic(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kWords)) {
    if (const auto defect = unreadable_part(obstacles[i].semantic.view())) {
      sink.obstacle(FindingCode::S104, i, ObstacleField::kSemantic,
                    complaint(name_of(obstacles[i]), *defect));
    }
    check_segments(obstacles[i], i, sink);
  }
}

}  // namespace mapwright::validators
