#include "mapcore/parts/merge.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>

#include "mapcore/parts/sewing.hpp"

namespace mapwright {
namespace {

// An obstacle of the result: where it is from, and which parts have it.
struct Entry {
  Obstacle obstacle;
  std::size_t part = 0;      // the first that has it
  std::size_t last_use = 0;  // the last part that was found to have it
};

using Ends = std::tuple<double, double, double, double>;

Ends ends_of(const Segment& s) {
  const auto a = std::pair(s.a.x, s.a.y), b = std::pair(s.b.x, s.b.y);
  const auto& [p, q] = std::minmax(a, b);
  return {p.first, p.second, q.first, q.second};
}

bool share_a_segment(const Obstacle& p, const Obstacle& q) {
  std::set<Ends> ends;
  for (const auto& segment : p.segments) ends.insert(ends_of(segment));
  return std::any_of(q.segments.begin(), q.segments.end(),
                     [&](const Segment& segment) { return ends.count(ends_of(segment)) > 0; });
}

class Merger {
 public:
  Merger(const std::vector<MergePart>& parts, MergePreference preference)
      : names_(parts), preference_(preference) {
    for (const auto& part : parts) {
      for (const auto& obstacle : part.map.obstacles) last_id_ = std::max(last_id_, obstacle.id);
    }
    if (last_id_ == std::numeric_limits<std::int64_t>::max()) last_id_ = 0;
  }

  Result<void> add(std::size_t number, Sewn part) {
    if (!part.torn.empty()) return torn(number, part.torn.front());
    std::vector<std::size_t> entries, order;
    std::unordered_map<std::int64_t, std::int64_t> renumbered;
    for (std::size_t i = 0; i < part.map.obstacles.size(); ++i) {
      const auto entry = place(number, std::move(part.map.obstacles[i]), renumbered);
      if (!entry) return tl::unexpected(entry.error());
      entries.push_back(*entry);
      if (!part.was_cut[i]) order.push_back(*entry);
    }
    follow_renumbered(number, renumbered, entries);
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      if (order[i] != order[i + 1]) links_.push_back({order[i], order[i + 1]});
    }
    return {};
  }

  // Kahn's algorithm (1962), the smallest id first; where the parts contradict each other, the
  // smallest id of all that are left.
  std::vector<Obstacle> in_order() {
    std::vector<std::vector<std::size_t>> next(entries_.size());
    std::vector<std::size_t> before(entries_.size(), 0);
    for (const auto& [from, to] : links_) {
      next[from].push_back(to);
      ++before[to];
    }
    using Key = std::pair<std::int64_t, std::size_t>;
    std::priority_queue<Key, std::vector<Key>, std::greater<>> ready;
    std::set<Key> waiting;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Key key{entries_[i].obstacle.id, i};
      before[i] == 0 ? ready.push(key) : static_cast<void>(waiting.insert(key));
    }
    std::vector<Obstacle> obstacles;
    obstacles.reserve(entries_.size());
    while (!ready.empty() || !waiting.empty()) {
      if (ready.empty()) {
        ready.push(*waiting.begin());
        waiting.erase(waiting.begin());
      }
      const std::size_t i = ready.top().second;
      ready.pop();
      for (const std::size_t to : next[i]) {
        if (--before[to] != 0) continue;
        const Key key{entries_[to].obstacle.id, to};
        if (waiting.erase(key) > 0) ready.push(key);
      }
      obstacles.push_back(std::move(entries_[i].obstacle));
    }
    return obstacles;
  }

  std::vector<std::string> take_notes() { return std::move(notes_); }

 private:
  // The entry that an obstacle of a part becomes, or is already.
  Result<std::size_t> place(std::size_t part, Obstacle obstacle,
                            std::unordered_map<std::int64_t, std::int64_t>& renumbered) {
    auto& same_id = by_id_[obstacle.id];
    bool has_stranger = false;
    for (const std::size_t i : same_id) {
      Entry& entry = entries_[i];
      if (entry.last_use == part + 1) continue;  // this part has it already: an id used twice
      if (entry.obstacle == obstacle) {
        entry.last_use = part + 1;
        return i;
      }
      if (share_a_segment(entry.obstacle, obstacle)) return versions(part, i, std::move(obstacle));
      has_stranger = true;
    }
    if (has_stranger) {
      const std::int64_t old = obstacle.id;
      obstacle.id = next_free_id();
      renumbered.emplace(old, obstacle.id);
      notes_.push_back(names_[part].name + ": obstacle " + std::to_string(old) + " becomes " +
                       std::to_string(obstacle.id) + ": " +
                       names_[entries_[same_id.front()].part].name + " has another of that id");
    }
    entries_.push_back({std::move(obstacle), part, part + 1});
    by_id_[entries_.back().obstacle.id].push_back(entries_.size() - 1);
    return entries_.size() - 1;
  }

  std::int64_t next_free_id() {
    do ++last_id_;
    while (by_id_.count(last_id_) > 0);
    return last_id_;
  }

  Result<void> torn(std::size_t part, std::int64_t id) const {
    return usage_failure(
        names_[part].name + ": obstacle " + std::to_string(id) +
        " is a piece of one that was cut, but it, a piece beside it or the border was changed "
        "since: "
        "crop that part anew, or take out the tokens 'cut' and 'part_of' to make obstacles of the "
        "pieces");
  }

  Result<std::size_t> versions(std::size_t part, std::size_t i, Obstacle obstacle) {
    Entry& entry = entries_[i];
    const std::string what = "obstacle " + std::to_string(obstacle.id) + " is not the same in " +
                             names_[entry.part].name + " and " + names_[part].name;
    if (preference_ == MergePreference::kNone) {
      return usage_failure(what +
                           ", though both have it at the same place: choose by --prefer first or "
                           "--prefer last");
    }
    const bool is_first = preference_ == MergePreference::kFirst;
    notes_.push_back(what + ": that of " + names_[is_first ? entry.part : part].name + " counts");
    if (!is_first) entry.obstacle = std::move(obstacle);
    entry.last_use = part + 1;
    return i;
  }

  // Holes of an outline that got a new id.
  void follow_renumbered(std::size_t part,
                         const std::unordered_map<std::int64_t, std::int64_t>& renumbered,
                         const std::vector<std::size_t>& order) {
    if (renumbered.empty()) return;
    for (const std::size_t i : order) {
      if (entries_[i].part != part) continue;
      auto& semantic = entries_[i].obstacle.semantic;
      const auto outer = semantic.value(semantic_key::kInnerOf);
      if (!outer) continue;
      for (const auto& [from, to] : renumbered) {
        if (*outer != std::to_string(from)) continue;
        semantic = semantic.with_value(semantic_key::kInnerOf, std::to_string(to));
        break;
      }
    }
  }

  const std::vector<MergePart>& names_;
  MergePreference preference_;
  std::vector<Entry> entries_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> by_id_;
  std::vector<std::pair<std::size_t, std::size_t>> links_;
  std::vector<std::string> notes_;
  std::int64_t last_id_ = 0;
};

Border border_around(const std::vector<MergePart>& parts) {
  Border all = parts.front().map.border;
  for (const auto& part : parts) {
    const Border& border = part.map.border;
    all.left = std::min(all.left, border.left);
    all.top = std::max(all.top, border.top);
    all.right = std::max(all.right, border.right);
    all.bottom = std::min(all.bottom, border.bottom);
  }
  return all;
}

}  // namespace

Result<Merged> merge(std::vector<MergePart> parts, MergePreference preference) {
  Merged merged;
  if (parts.empty()) return merged;
  merged.map.border = border_around(parts);
  Merger merger(parts, preference);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (auto added = merger.add(i, sewn(std::move(parts[i].map))); !added)
      return tl::unexpected(added.error());
  }
  merged.map.obstacles = merger.in_order();
  merged.notes = merger.take_notes();
  return merged;
}

}  // namespace mapwright
