#include "mapcore/parts/families.hpp"

#include <unordered_map>

#include "mapcore/text/decimal.hpp"

namespace mapwright {

std::vector<std::size_t> outline_of_each(const Map& map) {
  std::unordered_map<std::int64_t, std::size_t> by_id;
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    by_id.try_emplace(map.obstacles[i].id, i);
  }
  std::vector<std::size_t> outlines(map.obstacles.size());
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    outlines[i] = i;
    const auto token = map.obstacles[i].semantic.value(semantic_key::kInnerOf);
    if (!token) continue;
    const auto id = text::read_integer(*token);
    const auto found = id.status == text::NumberStatus::kOk ? by_id.find(id.value) : by_id.end();
    if (found != by_id.end()) outlines[i] = found->second;
  }
  return outlines;
}

}  // namespace mapwright
