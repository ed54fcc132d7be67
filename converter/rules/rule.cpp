#include "converter/rules/rule.hpp"

#include <array>

namespace mapwright::converter {
namespace {

struct NamedKind {
  std::string_view name;
  FeatureKind kind;
};

constexpr std::array<NamedKind, 9> kKinds{{{"obstacle", FeatureKind::kObstacle},
                                           {"solid", FeatureKind::kSolid},
                                           {"room", FeatureKind::kRoom},
                                           {"wall", FeatureKind::kWall},
                                           {"steps", FeatureKind::kSteps},
                                           {"stairs", FeatureKind::kStairs},
                                           {"ramp", FeatureKind::kRamp},
                                           {"border", FeatureKind::kBorder},
                                           {"ignore", FeatureKind::kIgnore}}};

}  // namespace

std::string_view to_string(FeatureKind kind) {
  for (const auto& entry : kKinds) {
    if (entry.kind == kind) return entry.name;
  }
  return "ignore";
}

std::optional<FeatureKind> feature_kind(std::string_view name) {
  for (const auto& entry : kKinds) {
    if (entry.name == name) return entry.kind;
  }
  return std::nullopt;
}

}  // namespace mapwright::converter
