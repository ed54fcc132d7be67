#include "mapcore/diff/matching.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

namespace mapwright {
namespace {

using Index = std::uint32_t;

constexpr double kPlaceGrid_m = 1.0e-6;   // as the hash of shapes
constexpr double kShiftGrid_m = 1.0e-3;   // offsets that are one shift of the whole map
constexpr std::size_t kLeastShifted = 3;  // fewer prove no shift
constexpr double kSimilarSize = 3.0;      // of diagonals: greater ones are other things

double rounded(double value, double grid) {
  return std::round(value / grid);
}

// Kinds of shapes that an edit does not turn into each other.
int family(ShapeType type) {
  if (type == ShapeType::kStairs || type == ShapeType::kRamp) return static_cast<int>(type);
  return is_closed(type) ? 0 : 1;
}

class Matcher {
 public:
  Matcher(const ShapedMap& before, const ShapedMap& after, const MapDiffOptions& options)
      : before_(before),
        after_(after),
        longest_move_m_(options.longest_move_m),
        partner_of_before_(before.shapes.size(), kNoPartner),
        partner_of_after_(after.shapes.size(), kNoPartner) {}

  std::vector<Index> run() {
    match_in_place({0.0, 0.0});
    match_ids([this](Index b, Index a) { return same_shape(b, a); });
    if (const auto shift = common_shift()) match_in_place(*shift);
    match_nearest([this](Index b, Index a) { return move_of_same_shape(b, a); });
    match_ids([this](Index b, Index a) { return displacement(b, a).has_value(); });
    match_nearest([this](Index b, Index a) { return displacement(b, a); });
    return std::move(partner_of_before_);
  }

 private:
  using Cost = std::function<std::optional<double>(Index, Index)>;

  // What stands at one place with one shape.
  struct Key {
    std::uint64_t hash;
    double x, y;
    std::int64_t id;
    Index index;

    auto place() const { return std::tie(hash, x, y); }
    friend bool operator<(const Key& p, const Key& q) {
      return std::tie(p.hash, p.x, p.y, p.id, p.index) < std::tie(q.hash, q.x, q.y, q.id, q.index);
    }
  };

  void join(Index before, Index after) {
    partner_of_before_[before] = after;
    partner_of_after_[after] = before;
  }

  static std::vector<Index> unmatched(const std::vector<Index>& partners) {
    std::vector<Index> left;
    for (Index i = 0; i < partners.size(); ++i) {
      if (partners[i] == kNoPartner) left.push_back(i);
    }
    return left;
  }

  static std::vector<Key> keys(const ShapedMap& map, const std::vector<Index>& partners,
                               Point shift) {
    std::vector<Key> keys;
    for (const Index i : unmatched(partners)) {
      const auto& shape = map.shapes[i];
      const Point at = shape.anchor + shift;
      keys.push_back({shape.hash, rounded(at.x, kPlaceGrid_m), rounded(at.y, kPlaceGrid_m),
                      map.map->obstacles[i].id, i});
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  // The same shape, `shift` away from where it was.
  void match_in_place(Point shift) {
    const auto old_keys = keys(before_, partner_of_before_, shift);
    const auto new_keys = keys(after_, partner_of_after_, {0.0, 0.0});
    auto b = old_keys.begin();
    auto a = new_keys.begin();
    while (b != old_keys.end() && a != new_keys.end()) {
      if (b->place() < a->place()) {
        ++b;
      } else if (a->place() < b->place()) {
        ++a;
      } else {
        match_group(b, old_keys.end(), a, new_keys.end());
      }
    }
  }

  // Of several at one place those of one id belong together, then any, in order.
  template <class Iterator>
  void match_group(Iterator& b, Iterator b_end, Iterator& a, Iterator a_end) {
    const Iterator b_first = b;
    const Iterator a_first = a;
    while (b != b_end && b->place() == b_first->place()) ++b;
    while (a != a_end && a->place() == a_first->place()) ++a;
    for (auto i = b_first, j = a_first; i != b && j != a;) {
      if (i->id == j->id) {
        join((i++)->index, (j++)->index);
      } else {
        i->id < j->id ? ++i : ++j;
      }
    }
    for (auto i = b_first, j = a_first; i != b && j != a;) {
      if (partner_of_before_[i->index] != kNoPartner) {
        ++i;
      } else if (partner_of_after_[j->index] != kNoPartner) {
        ++j;
      } else {
        join((i++)->index, (j++)->index);
      }
    }
  }

  // Ids that one unmatched obstacle has, sorted.
  static std::vector<std::pair<std::int64_t, Index>> unique_ids(
      const ShapedMap& map, const std::vector<Index>& partners) {
    std::vector<std::pair<std::int64_t, Index>> ids;
    for (const Index i : unmatched(partners)) ids.emplace_back(map.map->obstacles[i].id, i);
    std::sort(ids.begin(), ids.end());
    std::vector<std::pair<std::int64_t, Index>> unique;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const bool as_last = i > 0 && ids[i - 1].first == ids[i].first;
      const bool as_next = i + 1 < ids.size() && ids[i + 1].first == ids[i].first;
      if (!as_last && !as_next) unique.push_back(ids[i]);
    }
    return unique;
  }

  void match_ids(const std::function<bool(Index, Index)>& may_match) {
    const auto old_ids = unique_ids(before_, partner_of_before_);
    const auto new_ids = unique_ids(after_, partner_of_after_);
    for (auto b = old_ids.begin(), a = new_ids.begin(); b != old_ids.end() && a != new_ids.end();) {
      if (b->first != a->first) {
        b->first < a->first ? ++b : ++a;
        continue;
      }
      if (may_match(b->second, a->second)) join(b->second, a->second);
      ++b, ++a;
    }
  }

  bool same_shape(Index before, Index after) const {
    return before_.shapes[before].hash == after_.shapes[after].hash;
  }

  Point offset(Index before, Index after) const {
    return after_.shapes[after].anchor - before_.shapes[before].anchor;
  }

  // Offsets of what moved, of which there is no doubt: found by id, or the only one of its shape.
  std::vector<Point> sure_offsets() const {
    std::vector<Point> offsets;
    for (Index b = 0; b < partner_of_before_.size(); ++b) {
      const Index a = partner_of_before_[b];
      if (a == kNoPartner) continue;
      const Point d = offset(b, a);
      if (length(d) > kShiftGrid_m) offsets.push_back(d);
    }
    const auto old_keys = keys(before_, partner_of_before_, {0.0, 0.0});
    const auto new_keys = keys(after_, partner_of_after_, {0.0, 0.0});
    for (std::size_t i = 0; i < old_keys.size(); ++i) {
      const auto same = [&](const Key& p, const Key& q) { return p.hash < q.hash; };
      const auto olds = std::equal_range(old_keys.begin(), old_keys.end(), old_keys[i], same);
      const auto news = std::equal_range(new_keys.begin(), new_keys.end(), old_keys[i], same);
      if (olds.second - olds.first == 1 && news.second - news.first == 1) {
        offsets.push_back(offset(old_keys[i].index, news.first->index));
      }
    }
    return offsets;
  }

  // The offset that most of what moved has in common, if at least half of it has.
  std::optional<Point> common_shift() const {
    std::vector<std::pair<double, double>> cells;
    for (const Point d : sure_offsets()) {
      cells.emplace_back(rounded(d.x, kShiftGrid_m), rounded(d.y, kShiftGrid_m));
    }
    std::sort(cells.begin(), cells.end());
    std::size_t most = 0;
    std::pair<double, double> best;
    for (std::size_t i = 0, run = 0; i < cells.size(); ++i) {
      run = i > 0 && cells[i] == cells[i - 1] ? run + 1 : 1;
      if (run > most) std::tie(most, best) = std::tie(run, cells[i]);
    }
    if (most < kLeastShifted || 2 * most < cells.size()) return std::nullopt;
    return Point{best.first * kShiftGrid_m, best.second * kShiftGrid_m};
  }

  std::optional<double> move_of_same_shape(Index before, Index after) const {
    if (!same_shape(before, after)) return std::nullopt;
    const double moved_m = length(offset(before, after));
    if (moved_m > longest_move_m_) return std::nullopt;
    return moved_m;
  }

  // How far the corners of the box have moved; nothing for what is too far off, too different in
  // size, or of another family of shapes.
  std::optional<double> displacement(Index before, Index after) const {
    const Obstacle& old_one = before_.map->obstacles[before];
    const Obstacle& new_one = after_.map->obstacles[after];
    if (family(old_one.shape_type) != family(new_one.shape_type)) return std::nullopt;
    const Box& p = before_.shapes[before].box;
    const Box& q = after_.shapes[after].box;
    if (p.is_empty() || q.is_empty()) return std::nullopt;
    const double p_size = std::hypot(p.width(), p.height());
    const double q_size = std::hypot(q.width(), q.height());
    if (p_size > kSimilarSize * q_size || q_size > kSimilarSize * p_size) return std::nullopt;
    const double moved_m = std::max({std::abs(p.min_x - q.min_x), std::abs(p.min_y - q.min_y),
                                     std::abs(p.max_x - q.max_x), std::abs(p.max_y - q.max_y)});
    if (moved_m > std::min(longest_move_m_, std::max(p_size, q_size))) return std::nullopt;
    return moved_m;
  }

  // Positions of unmatched new obstacles by the cell of their box's corner.
  struct Cell {
    double x, y;
    Index index;
    friend bool operator<(const Cell& p, const Cell& q) {
      return std::tie(p.x, p.y, p.index) < std::tie(q.x, q.y, q.index);
    }
  };

  std::vector<Cell> cells_of_after() const {
    std::vector<Cell> cells;
    for (const Index a : unmatched(partner_of_after_)) {
      const Box& box = after_.shapes[a].box;
      if (!box.is_empty()) cells.push_back({cell(box.min_x), cell(box.min_y), a});
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  // Corners of partners are in the same cell or in neighbours.
  double cell(double coordinate) const { return std::floor(coordinate / longest_move_m_); }

  // The cheapest pairs first, each obstacle once.
  void match_nearest(const Cost& cost) {
    const auto cells = cells_of_after();
    std::vector<std::tuple<double, Index, Index>> pairs;
    for (const Index b : unmatched(partner_of_before_)) {
      each_near(before_.shapes[b].box, cells, [&](Index a) {
        if (const auto price = cost(b, a)) pairs.emplace_back(*price, b, a);
      });
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [price, b, a] : pairs) {
      if (partner_of_before_[b] == kNoPartner && partner_of_after_[a] == kNoPartner) join(b, a);
    }
  }

  template <class Visit>
  void each_near(const Box& box, const std::vector<Cell>& cells, const Visit& visit) const {
    if (box.is_empty()) return;
    const double row = cell(box.min_y);
    for (const double column : {-1.0, 0.0, 1.0}) {
      const double x = cell(box.min_x) + column;
      const auto first = std::lower_bound(cells.begin(), cells.end(), Cell{x, row - 1.0, 0});
      for (auto at = first; at != cells.end() && at->x == x && at->y <= row + 1.0; ++at) {
        visit(at->index);
      }
    }
  }

  const ShapedMap& before_;
  const ShapedMap& after_;
  double longest_move_m_;
  std::vector<Index> partner_of_before_, partner_of_after_;
};

}  // namespace

ShapedMap::ShapedMap(const Map& m) : map(&m) {
  shapes.reserve(m.obstacles.size());
  for (const auto& obstacle : m.obstacles) shapes.push_back(shape_of(obstacle));
}

std::vector<std::uint32_t> match_obstacles(const ShapedMap& before, const ShapedMap& after,
                                           const MapDiffOptions& options) {
  return Matcher(before, after, options).run();
}

}  // namespace mapwright
