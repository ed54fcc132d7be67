#include "mapcore/diff/comparison.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "mapcore/geometry/segment_index.hpp"

namespace mapwright {
namespace {

std::string number_text(double value) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), value);
  return {std::begin(buffer), result.ptr};
}

bool near(Point p, Point q, double tolerance_m) {
  return std::abs(p.x - q.x) <= tolerance_m && std::abs(p.y - q.y) <= tolerance_m;
}

// Segments of both in an order in which they correspond.
struct Alignment {
  std::size_t first_before = 0, first_after = 0, count = 0;

  std::size_t before(std::size_t k) const { return (first_before + k) % count; }
  std::size_t after(std::size_t k) const { return (first_after + k) % count; }
};

// A ring that was changed a little may have another lowest leftmost vertex: take the one that is
// where the old one was, seen from the corner of the boxes.
std::size_t corresponding_start(const ShapedObstacle& before, const ShapedObstacle& after) {
  if (!is_ring(before.obstacle) || !is_ring(after.obstacle)) return after.shape.first;
  const Point shift{after.shape.box.min_x - before.shape.box.min_x,
                    after.shape.box.min_y - before.shape.box.min_y};
  const Point wanted = before.shape.anchor + shift;
  const auto& segments = after.obstacle.segments;
  const auto nearest =
      std::min_element(segments.begin(), segments.end(), [&](const Segment& p, const Segment& q) {
        return squared_length(p.a - wanted) < squared_length(q.a - wanted);
      });
  return static_cast<std::size_t>(nearest - segments.begin());
}

Alignment align(const ShapedObstacle& before, const ShapedObstacle& after) {
  return {before.shape.first, corresponding_start(before, after), after.obstacle.segments.size()};
}

// True if the shapes are the same but for their place.
bool same_shape(const ShapedObstacle& before, const ShapedObstacle& after,
                const Alignment& alignment, double tolerance_m) {
  const auto& old_ones = before.obstacle.segments;
  const auto& new_ones = after.obstacle.segments;
  const Point offset = new_ones[alignment.after(0)].a - old_ones[alignment.before(0)].a;
  for (std::size_t k = 0; k < alignment.count; ++k) {
    const Segment& p = old_ones[alignment.before(k)];
    const Segment& q = new_ones[alignment.after(k)];
    if (!near(p.a + offset, q.a, tolerance_m) || !near(p.b + offset, q.b, tolerance_m)) {
      return false;
    }
  }
  return true;
}

SegmentIndex index_of(const Obstacle& obstacle) {
  std::vector<IndexedSegment> lines;
  for (const auto& segment : obstacle.segments) lines.push_back({segment.a, segment.b, 0});
  return SegmentIndex(std::move(lines));
}

double farthest_m(const Obstacle& from, const SegmentIndex& lines) {
  double farthest = 0.0;
  for (const auto& segment : from.segments) {
    for (const Point end : {segment.a, segment.b}) {
      const auto nearest = lines.nearest(end);
      farthest = std::max(farthest, nearest ? nearest->distance_m : 0.0);
    }
  }
  return farthest;
}

void compare_shapes(const ShapedObstacle& before, const ShapedObstacle& after,
                    const Alignment& alignment, double tolerance_m, ObstacleChange& change) {
  const std::size_t count = before.obstacle.segments.size();
  const double slack_m = tolerance_m + tolerance::kArithmetic_m;
  if (count == alignment.count && (count == 0 || same_shape(before, after, alignment, slack_m))) {
    if (count == 0) return;
    change.offset = after.obstacle.segments[alignment.after(0)].a -
                    before.obstacle.segments[alignment.before(0)].a;
    change.moved = !near(change.offset, {}, slack_m);
    if (!change.moved) change.offset = {};
    return;
  }
  change.reshaped = true;
  change.deviation_m = std::max(farthest_m(before.obstacle, index_of(after.obstacle)),
                                farthest_m(after.obstacle, index_of(before.obstacle)));
  const Obstacle turned = reversed(after.obstacle);
  const ObstacleShape shape = shape_of(turned);
  change.reversed =
      shape.hash == before.shape.hash && near(shape.anchor, before.shape.anchor, slack_m);
}

// Values that changed in one way, with the segments they changed of.
class AttributeChanges {
 public:
  explicit AttributeChanges(std::vector<AttributeChange>& changes) : changes_(changes) {}

  void add(const char* field, std::string before, std::string after, std::size_t segment) {
    const auto [entry, is_new] = known_.try_emplace({field, before, after}, changes_.size());
    if (is_new) changes_.push_back({field, std::move(before), std::move(after), {}});
    if (segment > 0) changes_[entry->second].segments.push_back(segment);
  }

 private:
  std::vector<AttributeChange>& changes_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> known_;
};

std::string in_out_text(InOut in_out) {
  return in_out == InOut::kIndoor ? "indoor" : "outdoor";
}

void compare_segments(const ShapedObstacle& before, const ShapedObstacle& after,
                      const Alignment& alignment, double tolerance_m, AttributeChanges& changes) {
  for (std::size_t k = 0; k < alignment.count; ++k) {
    const Segment& p = before.obstacle.segments[alignment.before(k)];
    const std::size_t number = alignment.after(k);
    const Segment& q = after.obstacle.segments[number];
    if (std::abs(p.height_m - q.height_m) > tolerance_m + tolerance::kArithmetic_m) {
      changes.add("height_m", number_text(p.height_m), number_text(q.height_m), number + 1);
    }
    if (p.in_out != q.in_out) {
      changes.add("in_out", in_out_text(p.in_out), in_out_text(q.in_out), number + 1);
    }
    if (p.semantic != q.semantic) {
      changes.add("segment_semantic", p.semantic.str(), q.semantic.str(), number + 1);
    }
  }
}

// All values there are, in order, once each: "0.2, 0.4".
template <class Value, class Get, class Text>
std::string values_text(const Obstacle& obstacle, const Get& get, const Text& text) {
  std::set<Value> values;
  for (const auto& segment : obstacle.segments) values.insert(get(segment));
  std::string all;
  for (const auto& value : values) all += (all.empty() ? "" : ", ") + text(value);
  return all;
}

// Where segments do not correspond, what all of them have.
void compare_values(const Obstacle& before, const Obstacle& after, AttributeChanges& changes) {
  const auto add = [&](const char* field, const auto& text_of) {
    std::string old_text = text_of(before);
    std::string new_text = text_of(after);
    if (old_text != new_text) changes.add(field, std::move(old_text), std::move(new_text), 0);
  };
  add("height_m", [](const Obstacle& o) {
    return values_text<double>(
        o, [](const Segment& s) { return s.height_m; }, number_text);
  });
  add("in_out", [](const Obstacle& o) {
    return values_text<InOut>(
        o, [](const Segment& s) { return s.in_out; }, in_out_text);
  });
  add("segment_semantic", [](const Obstacle& o) {
    return values_text<std::string>(
        o, [](const Segment& s) { return s.semantic.str(); },
        [](const std::string& text) { return text; });
  });
}

}  // namespace

ObstacleChange compare(const ShapedObstacle& before, const ShapedObstacle& after,
                       double tolerance_m) {
  ObstacleChange change;
  change.renumbered = before.obstacle.id != after.obstacle.id;
  const Alignment alignment = align(before, after);
  compare_shapes(before, after, alignment, tolerance_m, change);
  AttributeChanges attributes(change.attributes);
  if (before.obstacle.shape_type != after.obstacle.shape_type) {
    attributes.add("shape_type", std::to_string(static_cast<int>(before.obstacle.shape_type)),
                   std::to_string(static_cast<int>(after.obstacle.shape_type)), 0);
  }
  if (before.semantic != after.semantic) {
    attributes.add("semantic", before.semantic.str(), after.semantic.str(), 0);
  }
  if (before.obstacle.segments.size() == alignment.count && !change.reversed) {
    compare_segments(before, after, alignment, tolerance_m, attributes);
  } else {
    compare_values(before.obstacle, after.obstacle, attributes);
  }
  return change;
}

}  // namespace mapwright
