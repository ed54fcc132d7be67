#include "mapcore/geometry/segment_index.hpp"

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/packed_tree.hpp"

namespace mapwright {

// Not Boost's R-tree: that one prunes by its own rounded distances and segment–box tests, and an
// exact answer needs bounds that never exclude what the exact test would find.
struct SegmentIndex::Tree : PackedTree {
  using PackedTree::PackedTree;
};

namespace {

double squared_distance(const Box& box, Point p) {
  const double dx = std::max({box.min_x - p.x, 0.0, p.x - box.max_x});
  const double dy = std::max({box.min_y - p.y, 0.0, p.y - box.max_y});
  return dx * dx + dy * dy;
}

double squared_distance(Point p, Point q) {
  return squared_length(q - p);
}

// Kept within the segment's box, so that no point is nearer than the boxes around it.
Point closest_point(Point p, const IndexedSegment& s) {
  const Point q = closest_point_on_segment(p, s.a, s.b);
  const Box box = box_of(s.a, s.b);
  return {std::clamp(q.x, box.min_x, box.max_x), std::clamp(q.y, box.min_y, box.max_y)};
}

// Decides which boxes may hold something that a disc moving from a to b meets: those that come near
// its box and are not beside its line, rounding allowed for.
class Corridor {
 public:
  Corridor(Point a, Point b, double radius_m)
      : a_(a),
        direction_(b - a),
        reach_m_(radius_m + kSlack * (std::abs(a.x) + std::abs(a.y) + std::abs(b.x) +
                                      std::abs(b.y) + radius_m)),
        box_(box_of(a, b).inflated(reach_m_)) {}

  bool may_meet(const Box& box) const {
    return boxes_meet(box, box_) && !lies_beside(box.inflated(reach_m_));
  }

 private:
  bool lies_beside(const Box& box) const {
    const double half_width = 0.5 * box.width(), half_height = 0.5 * box.height();
    const Point to_center{box.min_x + half_width - a_.x, box.min_y + half_height - a_.y};
    const double dx = std::abs(direction_.x), dy = std::abs(direction_.y);
    const double offset = std::abs(cross(direction_, to_center));
    const double reach = dx * half_height + dy * half_width;
    const double size = std::abs(a_.x) + std::abs(a_.y) + std::abs(to_center.x) +
                        std::abs(to_center.y) + half_width + half_height;
    return offset > reach + 32.0 * DBL_EPSILON * (dx + dy) * size;
  }

  static constexpr double kSlack = 16.0 * DBL_EPSILON;

  Point a_, direction_;
  double reach_m_;
  Box box_;
};

bool segments_meet(Point a, Point b, const IndexedSegment& s) {
  return boxes_meet(box_of(a, b), box_of(s.a, s.b)) && meet(a, b, s.a, s.b).kind != Meeting::kNone;
}

bool is_nearer(Point a, Point b, const IndexedSegment& s, double radius_m) {
  const IndexedSegment way{a, b, 0};
  return distance(a, closest_point(a, s)) < radius_m ||
         distance(b, closest_point(b, s)) < radius_m ||
         distance(s.a, closest_point(s.a, way)) < radius_m ||
         distance(s.b, closest_point(s.b, way)) < radius_m ||
         (radius_m > 0.0 && segments_meet(a, b, s));
}

}  // namespace

SegmentIndex::SegmentIndex(std::vector<IndexedSegment> segments) : segments_(std::move(segments)) {
  assert(segments_.size() <= UINT32_MAX);
  tree_ = std::make_unique<Tree>(
      segments_.size(), [this](std::size_t i) { return box_of(segments_[i].a, segments_[i].b); });
}

SegmentIndex::SegmentIndex(SegmentIndex&&) noexcept = default;
SegmentIndex& SegmentIndex::operator=(SegmentIndex&&) noexcept = default;
SegmentIndex::~SegmentIndex() = default;

bool SegmentIndex::query(const Box& box, const std::function<bool(std::size_t)>& visit) const {
  return tree_->walk([&](const Box& node) { return boxes_meet(node, box); },
                     [&](std::size_t i) {
                       return !boxes_meet(box_of(segments_[i].a, segments_[i].b), box) || visit(i);
                     });
}

std::optional<SegmentIndex::Nearest> SegmentIndex::nearest(Point p) const {
  if (segments_.empty()) return std::nullopt;
  Nearest best{SIZE_MAX, 0.0, {}};
  double bound = HUGE_VAL;
  tree_->approach([&](const Box& node) { return squared_distance(node, p); }, bound,
                  [&](std::size_t i) {
                    const Point q = closest_point(p, segments_[i]);
                    const double d = squared_distance(p, q);
                    if (d > bound || (d == bound && i > best.segment)) return;
                    bound = d;
                    best = {i, 0.0, q};
                  });
  best.distance_m = distance(p, best.at);
  return best;
}

double SegmentIndex::clearance_m(Point p, double limit_m) const {
  double bound = limit_m * limit_m;
  Point nearest = p;
  bool found = false;
  tree_->approach([&](const Box& node) { return squared_distance(node, p); }, bound,
                  [&](std::size_t i) {
                    const Point q = closest_point(p, segments_[i]);
                    const double d = squared_distance(p, q);
                    if (d >= bound) return;
                    bound = d;
                    nearest = q;
                    found = true;
                  });
  return found ? std::min(limit_m, distance(p, nearest)) : limit_m;
}

bool SegmentIndex::meets(Point a, Point b) const {
  return !query_meeting(a, b, [](std::size_t) { return false; });
}

bool SegmentIndex::query_meeting(Point a, Point b,
                                 const std::function<bool(std::size_t)>& visit) const {
  const Corridor corridor(a, b, 0.0);
  return tree_->walk([&](const Box& node) { return corridor.may_meet(node); },
                     [&](std::size_t i) { return !segments_meet(a, b, segments_[i]) || visit(i); });
}

bool SegmentIndex::comes_near(Point a, Point b, double radius_m) const {
  const Corridor corridor(a, b, radius_m);
  return !tree_->walk([&](const Box& node) { return corridor.may_meet(node); },
                      [&](std::size_t i) { return !is_nearer(a, b, segments_[i], radius_m); });
}

}  // namespace mapwright
