#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Their values are judged by checks of their own (S105, T202).
bool is_judged_elsewhere(std::string_view key) {
  return key == semantic_key::kInnerOf || key == semantic_key::kNormal;
}

bool is_known_key(std::string_view key) {
  static constexpr std::array kKeys{semantic_key::kInnerOf, semantic_key::kNormal,
                                    semantic_key::kLevel, semantic_key::kSource,
                                    semantic_key::kName};
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

std::string_view without_blanks_behind(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

std::optional<std::string> defect_of(const Semantic& semantic) {
  if (semantic.view().find('=') == std::string_view::npos) return std::nullopt;
  std::vector<std::string_view> keys;
  for (const auto token : semantic.tokens()) {
    const auto equals = token.find('=');
    if (equals == token.npos) continue;
    const auto key = without_blanks_behind(token.substr(0, equals));
    const std::string quoted = "'" + std::string(token) + "'";
    if (key.empty()) return quoted + " has no key in front of '='";
    if (equals + 1 == token.size() && !is_judged_elsewhere(key)) {
      return quoted + " has no value behind '='";
    }
    if (is_known_key(key) && std::find(keys.begin(), keys.end(), key) != keys.end()) {
      return "the key '" + std::string(key) + "' stands twice, and only the first counts";
    }
    keys.push_back(key);
  }
  return std::nullopt;
}

std::string complaint(const std::string& subject, const std::string& defect) {
  return "in the semantic string of " + subject + " " + defect + "; complete it or take it away";
}

// Segments of an obstacle mostly share one string: looked at once.
void check_segments(const Obstacle& obstacle, std::size_t i, FindingSink& sink) {
  const char* last_text = nullptr;
  std::optional<std::string> defect;
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const Semantic& semantic = obstacle.segments[k].semantic;
    if (semantic.view().data() != last_text) {
      last_text = semantic.view().data();
      defect = defect_of(semantic);
    }
    if (!defect) continue;
    sink.segment(FindingCode::S124, i, k, SegmentField::kSemantic, obstacle.segments[k].a,
                 complaint(name_of(obstacle, k), *defect));
  }
}

}  // namespace

void check_malformed_token(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kWords)) {
    if (const auto defect = defect_of(obstacles[i].semantic)) {
      sink.obstacle(FindingCode::S124, i, ObstacleField::kSemantic,
                    complaint(name_of(obstacles[i]), *defect));
    }
    check_segments(obstacles[i], i, sink);
  }
}

}  // namespace mapwright::validators
