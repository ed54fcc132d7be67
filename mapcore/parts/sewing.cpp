#include "mapcore/parts/sewing.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <unordered_map>

#include "mapcore/parts/cut.hpp"
#include "mapcore/parts/cut_record.hpp"
#include "mapcore/parts/piece_keys.hpp"

namespace mapwright {
namespace {

std::vector<Obstacle> cut_again(const CutRecord& record, const Box& box) {
  Map map;
  map.obstacles = record.family;
  std::vector<std::size_t> family(record.family.size());
  std::iota(family.begin(), family.end(), std::size_t{0});
  std::vector<Obstacle> pieces;
  Cutter(map, box, record.resolution_m).cut(family, pieces);
  return pieces;
}

// Pieces beyond the first have ids of the part they are in.
class IdTranslation {
 public:
  void add(std::int64_t expected, std::int64_t found) {
    ids_[std::to_string(expected)] = std::to_string(found);
  }

  Semantic of(const Semantic& semantic) const {
    const auto outer = semantic.value(semantic_key::kInnerOf);
    const auto known = outer ? ids_.find(std::string(*outer)) : ids_.end();
    if (known == ids_.end() || known->second == *outer) return semantic;
    return semantic.with_value(semantic_key::kInnerOf, known->second);
  }

 private:
  std::unordered_map<std::string, std::string> ids_;
};

bool are_the_pieces(const std::vector<Obstacle>& expected, std::span<const Obstacle> found) {
  if (found.size() < expected.size()) return false;
  IdTranslation ids;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Obstacle &p = expected[i], &q = found[i];
    ids.add(p.id, q.id);
    if (p.shape_type != q.shape_type || p.segments != q.segments) return false;
    if (ids.of(p.semantic) != q.semantic) return false;
  }
  return !expected.empty() && expected.front().id == found.front().id;
}

}  // namespace

bool has_pieces(const Map& map) {
  return std::any_of(map.obstacles.begin(), map.obstacles.end(), [](const Obstacle& obstacle) {
    return obstacle.semantic.value(piece_key::kCut) || obstacle.semantic.value(piece_key::kPartOf);
  });
}

Sewn sewn(Map map) {
  Sewn whole;
  whole.map.border = map.border;
  auto& obstacles = map.obstacles;
  for (std::size_t i = 0; i < obstacles.size();) {
    const auto token = obstacles[i].semantic.value(piece_key::kCut);
    auto record = token ? parse_cut_record(*token) : std::nullopt;
    const auto pieces = record ? cut_again(*record, map.border.box()) : std::vector<Obstacle>();
    if (record && are_the_pieces(pieces, std::span(obstacles).subspan(i))) {
      std::move(record->family.begin(), record->family.end(),
                std::back_inserter(whole.map.obstacles));
      whole.was_cut.resize(whole.map.obstacles.size(), true);
      i += pieces.size();
      continue;
    }
    if (record || obstacles[i].semantic.value(piece_key::kPartOf))
      whole.torn.push_back(obstacles[i].id);
    whole.map.obstacles.push_back(std::move(obstacles[i++]));
    whole.was_cut.push_back(false);
  }
  return whole;
}

}  // namespace mapwright
