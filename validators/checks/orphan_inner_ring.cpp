#include <charconv>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

using Positions = std::unordered_multimap<std::int64_t, std::size_t>;

bool has_outer(const Obstacle& obstacle) {
  return obstacle.semantic.value(semantic_key::kInnerOf).has_value();
}

std::optional<std::int64_t> outer_id(std::string_view text) {
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return id;
}

Positions positions_by_id(const Map& map) {
  Positions positions;
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) positions.emplace(map.obstacles[i].id, i);
  return positions;
}

// What is wrong with the token; nothing where an outline of that id holds the ring.
std::optional<std::string> defect_of(const CheckContext& context, const Positions& positions,
                                     std::size_t inner) {
  const auto& obstacles = context.map().obstacles;
  const auto token = obstacles[inner].semantic.value(semantic_key::kInnerOf).value();
  const auto id = outer_id(token);
  if (!id) return "'" + std::string(token) + "' is not the id of an obstacle";
  const auto [from, to] = positions.equal_range(*id);
  if (from == to) return "there is no obstacle " + std::to_string(*id);
  for (auto outer = from; outer != to; ++outer) {
    const bool is_ring = context.outlines()[outer->second].is_ring;
    // An outline that is broken itself is told of by others.
    if (!is_ring && is_closed(obstacles[outer->second].shape_type)) return std::nullopt;
    if (holds(context, outer->second, inner)) return std::nullopt;
  }
  return "obstacle " + std::to_string(*id) + " is no outline around it";
}

}  // namespace

void check_orphan_inner_ring(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  std::optional<Positions> positions;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!has_outer(obstacles[i])) continue;
    if (!positions) positions = positions_by_id(context.map());
    if (const auto defect = defect_of(context, *positions, i)) {
      sink.obstacle(FindingCode::S105, i, ObstacleField::kSemantic,
                    name_of(obstacles[i]) + " calls itself an inner ring, but " + *defect +
                        "; correct inner_of or take it away");
    }
  }
}

}  // namespace mapwright::validators
