#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

using Ends = std::array<double, 4>;

struct Entry {
  Ends ends;
  std::size_t segment;
};

// A wall drawn to and fro has its segments twice. In an outline the way back is a spike (G104), and
// the closing segment of stairs may lie on the top step.
bool direction_matters(ShapeType type) {
  return !is_open_chain(type);
}

Ends ends_of(const Segment& segment, bool directed) {
  Point a = segment.a, b = segment.b;
  if (!directed && std::tie(b.x, b.y) < std::tie(a.x, a.y)) std::swap(a, b);
  return {a.x, a.y, b.x, b.y};
}

std::vector<Entry> sorted_entries(const Obstacle& obstacle) {
  const bool directed = direction_matters(obstacle.shape_type);
  std::vector<Entry> entries;
  entries.reserve(obstacle.segments.size());
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const Segment& segment = obstacle.segments[k];
    if (segment.a != segment.b) entries.push_back({ends_of(segment, directed), k});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& p, const Entry& q) {
    return std::tie(p.ends, p.segment) < std::tie(q.ends, q.segment);
  });
  return entries;
}

void check_obstacle(const Obstacle& obstacle, std::size_t i, FindingSink& sink) {
  const auto entries = sorted_entries(obstacle);
  for (std::size_t k = 1; k < entries.size(); ++k) {
    if (entries[k].ends != entries[k - 1].ends) continue;
    const std::size_t segment = entries[k].segment;
    sink.segment(FindingCode::G111, i, segment,
                 name_of(obstacle, segment) + " is segment " +
                     std::to_string(entries[k - 1].segment + 1) + " again; remove one of them");
    append(sink.geometry(), geometry_of(obstacle.segments[entries[k - 1].segment]));
  }
}

}  // namespace

// A simple ring has no segment twice, so few obstacles need the search.
void check_duplicate_segment(const CheckContext& context, FindingSink& sink) {
  for_each_suspect_chain(
      context, [&](const Obstacle& obstacle, std::size_t i) { check_obstacle(obstacle, i, sink); });
}

}  // namespace mapwright::validators
