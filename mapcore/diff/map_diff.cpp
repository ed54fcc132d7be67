#include "mapcore/diff/map_diff.hpp"

#include <charconv>
#include <cmath>
#include <unordered_map>

#include "mapcore/diff/comparison.hpp"
#include "mapcore/diff/matching.hpp"

namespace mapwright {
namespace {

// What became of the ids: those of matched obstacles.
using NewIds = std::unordered_map<std::int64_t, std::int64_t>;

NewIds new_ids(const Map& before, const Map& after, const std::vector<std::uint32_t>& partners) {
  NewIds ids;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i] == kNoPartner) continue;
    ids.try_emplace(before.obstacles[i].id, after.obstacles[partners[i]].id);
  }
  return ids;
}

// The semantic string with the ids of today.
Semantic translated(const Semantic& semantic, const NewIds& ids) {
  const auto text = semantic.value(semantic_key::kInnerOf);
  if (!text) return semantic;
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), id);
  const auto found =
      error == std::errc{} && end == text->data() + text->size() ? ids.find(id) : ids.end();
  if (found == ids.end()) return semantic;
  return semantic.with_value(semantic_key::kInnerOf, std::to_string(found->second));
}

bool same(const Border& p, const Border& q, double tolerance_m) {
  const auto near = [&](double a, double b) {
    return a == b || std::abs(a - b) <= tolerance_m + tolerance::kArithmetic_m;
  };
  return near(p.left, q.left) && near(p.top, q.top) && near(p.right, q.right) &&
         near(p.bottom, q.bottom);
}

void count(const ObstacleChange& change, MapDiffCounts& counts) {
  counts.added += change.added() ? 1 : 0;
  counts.removed += change.removed() ? 1 : 0;
  counts.moved += change.moved ? 1 : 0;
  counts.reshaped += change.reshaped ? 1 : 0;
  counts.reattributed += change.attributes.empty() ? 0 : 1;
  counts.renumbered += change.renumbered ? 1 : 0;
  counts.unchanged += change.is_difference() ? 0 : 1;
}

}  // namespace

bool MapDiff::same() const {
  return !border_before &&
         counts.added + counts.removed + counts.moved + counts.reshaped + counts.reattributed == 0;
}

MapDiff diff_maps(const Map& before, const Map& after, const MapDiffOptions& options) {
  const ShapedMap old_map(before);
  const ShapedMap new_map(after);
  const auto partners = match_obstacles(old_map, new_map, options);
  const NewIds ids = new_ids(before, after, partners);
  MapDiff diff;
  const auto add = [&](ObstacleChange change) {
    count(change, diff.counts);
    if (change.is_difference() || change.renumbered) diff.changes.push_back(std::move(change));
  };
  if (!same(before.border, after.border, options.tolerance_m)) {
    diff.border_before = before.border;
    diff.border_after = after.border;
  }
  std::vector<bool> is_partner(after.obstacles.size(), false);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    ObstacleChange change;
    if (const auto j = partners[i]; j != kNoPartner) {
      is_partner[j] = true;
      const Semantic semantic = translated(before.obstacles[i].semantic, ids);
      change = compare({before.obstacles[i], old_map.shapes[i], semantic},
                       {after.obstacles[j], new_map.shapes[j], after.obstacles[j].semantic},
                       options.tolerance_m);
      change.after = j;
    }
    change.before = i;
    add(std::move(change));
  }
  for (std::size_t j = 0; j < is_partner.size(); ++j) {
    if (is_partner[j]) continue;
    ObstacleChange change;
    change.after = j;
    add(std::move(change));
  }
  return diff;
}

}  // namespace mapwright
