#include "navcore/named_places.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "mapcore/tolerances.hpp"
#include "navcore/planning/route.hpp"

namespace mapwright::navcore {
namespace {

constexpr double kSpacing_m = 0.5;
constexpr double kStep_m = 0.1;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// Least number of letters to insert, leave out or replace (Levenshtein 1966).
std::size_t edit_distance(std::string_view p, std::string_view q) {
  std::vector<std::size_t> row(q.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < p.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < q.size(); ++j) {
      const std::size_t replaced = diagonal + (p[i] == q[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

// How unlike two names are; nothing where they have little in common.
std::optional<std::size_t> unlikeness(std::string_view asked, std::string_view name) {
  const std::string p = lower_case(asked), q = lower_case(name);
  const std::size_t edits = edit_distance(p, q);
  if (edits <= std::max<std::size_t>(1, p.size() / 3)) return edits;
  if (!p.empty() && q.find(p) != q.npos) return edits;
  return std::nullopt;
}

// Points at `distance_m` from the segment: in front of its middle first, then every half metre and
// beyond its ends; its right side, which is the free one, before its left.
std::vector<Point> points_beside(const BlockingSegment& segment, double distance_m) {
  std::vector<Point> points;
  const double length_m = distance(segment.a, segment.b);
  if (!(length_m > 0.0)) return points;
  const Point along = (1.0 / length_m) * (segment.b - segment.a);
  const Point right{along.y, -along.x};
  const Point middle = 0.5 * (segment.a + segment.b);
  const auto steps = static_cast<int>(0.5 * length_m / kSpacing_m);
  for (const double side_m : {distance_m, -distance_m}) {
    points.push_back(middle + side_m * right);
    for (int i = 1; i <= steps; ++i) {
      points.push_back(middle + i * kSpacing_m * along + side_m * right);
      points.push_back(middle - i * kSpacing_m * along + side_m * right);
    }
  }
  points.push_back(segment.a - distance_m * along);
  points.push_back(segment.b + distance_m * along);
  return points;
}

}  // namespace

std::vector<NamedPlace> named_places(const Map& map) {
  std::vector<NamedPlace> places;
  std::unordered_map<std::string_view, std::size_t> number_of;
  for (std::uint32_t i = 0; i < map.obstacles.size(); ++i) {
    const auto name = map.obstacles[i].semantic.value(semantic_key::kName);
    if (!name || name->empty()) continue;
    const auto [entry, is_new] = number_of.emplace(*name, places.size());
    if (is_new) places.push_back({std::string(*name), {}});
    places[entry->second].obstacles.push_back(i);
  }
  return places;
}

std::vector<std::string> similar_names(const std::vector<NamedPlace>& places, std::string_view name,
                                       std::size_t most) {
  std::vector<std::pair<std::size_t, std::string>> similar;
  for (const auto& place : places) {
    if (const auto distance = unlikeness(name, place.name)) {
      similar.emplace_back(*distance, place.name);
    }
  }
  std::sort(similar.begin(), similar.end());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(most, similar.size()); ++i) {
    names.push_back(std::move(similar[i].second));
  }
  return names;
}

PlaceFinder::PlaceFinder(const Map& map, const FreeSpace& space)
    : map_(map),
      space_(space),
      places_(named_places(map)),
      first_segment_(map.obstacles.size() + 1) {
  for (const auto& segment : space.segments()) ++first_segment_[segment.obstacle + 1];
  std::partial_sum(first_segment_.begin(), first_segment_.end(), first_segment_.begin());
}

const NamedPlace* PlaceFinder::find(std::string_view name) const {
  const auto found = std::find_if(places_.begin(), places_.end(),
                                  [&](const NamedPlace& place) { return place.name == name; });
  return found == places_.end() ? nullptr : &*found;
}

std::vector<BlockingSegment> PlaceFinder::outline_of(const NamedPlace& place) const {
  std::vector<BlockingSegment> outline;
  for (const std::uint32_t i : place.obstacles) {
    const auto first = space_.segments().begin();
    outline.insert(outline.end(), first + first_segment_[i], first + first_segment_[i + 1]);
  }
  std::stable_sort(outline.begin(), outline.end(),
                   [](const BlockingSegment& p, const BlockingSegment& q) {
                     return squared_length(p.b - p.a) > squared_length(q.b - q.a);
                   });
  return outline;
}

std::optional<Point> PlaceFinder::standing_point(
    const NamedPlace& place, double radius_m,
    const std::function<bool(Point)>& is_preferred) const {
  std::optional<Point> second_best;
  // True if the point is as good as any.
  const auto is_best = [&](Point p) {
    if (!space_.is_free(p, radius_m)) return false;
    if (!second_best) second_best = p;
    return is_preferred == nullptr || is_preferred(p);
  };
  for (const std::uint32_t i : place.obstacles) {
    if (first_segment_[i] != first_segment_[i + 1]) continue;
    const auto p = point_on_ramp(space_, map_.obstacles[i], radius_m);
    if (p && is_best(*p)) return p;
  }
  const auto outline = outline_of(place);
  for (double room_m = tolerance::kStandoff_m; room_m <= tolerance::kBesidePlace_m;
       room_m += kStep_m) {
    for (const auto& segment : outline) {
      for (const Point p : points_beside(segment, radius_m + room_m)) {
        if (is_best(p)) return p;
      }
    }
  }
  return second_best;
}

}  // namespace mapwright::navcore
