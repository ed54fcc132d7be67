#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Obstacles by their ids.
class Ids {
 public:
  explicit Ids(const CheckContext& context) : obstacles_(context.map().obstacles) {
    if (!context.survey().ids_may_repeat()) return;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) positions_.emplace(obstacles_[i].id, i);
    are_in_order_ = false;
  }

  std::vector<std::size_t> with(std::int64_t id) const {
    std::vector<std::size_t> found;
    if (are_in_order_) {
      const auto at = std::lower_bound(obstacles_.begin(), obstacles_.end(), id,
                                       [](const Obstacle& o, std::int64_t i) { return o.id < i; });
      if (at != obstacles_.end() && at->id == id) {
        found.push_back(static_cast<std::size_t>(at - obstacles_.begin()));
      }
    } else {
      const auto [from, to] = positions_.equal_range(id);
      for (auto at = from; at != to; ++at) found.push_back(at->second);
    }
    return found;
  }

 private:
  const std::vector<Obstacle>& obstacles_;
  bool are_in_order_ = true;
  std::unordered_multimap<std::int64_t, std::size_t> positions_;  // where they are not
};

bool has_outer(const Obstacle& obstacle) {
  return obstacle.semantic.value(semantic_key::kInnerOf).has_value();
}

std::optional<std::int64_t> outer_id(std::string_view text) {
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return id;
}

// What is wrong with the token; nothing where an outline of that id holds the ring.
std::optional<std::string> defect_of(const CheckContext& context, const Ids& ids,
                                     std::size_t inner) {
  const auto& obstacles = context.map().obstacles;
  const auto token = obstacles[inner].semantic.value(semantic_key::kInnerOf).value();
  const auto id = outer_id(token);
  if (!id) return "'" + std::string(token) + "' is not the id of an obstacle";
  const auto outers = ids.with(*id);
  if (outers.empty()) return "there is no obstacle " + std::to_string(*id);
  for (const std::size_t outer : outers) {
    const bool is_ring = context.outline(outer).is_ring;
    // An outline that is broken itself is told of by others.
    if (!is_ring && is_closed(obstacles[outer].shape_type)) return std::nullopt;
    if (holds(context, outer, inner)) return std::nullopt;
  }
  return "obstacle " + std::to_string(*id) + " is no outline around it";
}

}  // namespace

void check_orphan_inner_ring(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  std::optional<Ids> ids;
  for (const auto i : context.in_doubt(Doubt::kInnerRing)) {
    if (!has_outer(obstacles[i])) continue;
    if (!ids) ids.emplace(context);
    if (const auto defect = defect_of(context, *ids, i)) {
      sink.obstacle(FindingCode::S105, i, ObstacleField::kSemantic,
                    name_of(obstacles[i]) + " calls itself an inner ring, but " + *defect +
                        "; correct inner_of or take it away");
    }
  }
}

}  // namespace mapwright::validators
