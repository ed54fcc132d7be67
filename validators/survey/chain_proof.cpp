#include "validators/survey/chain_proof.hpp"

#include <algorithm>
#include <cmath>

#include "mapcore/geometry/filtered_turn.hpp"
#include "validators/shape/spike_gap.hpp"

namespace mapwright::validators {
namespace {

constexpr std::size_t kBlockSegments = 16;

// Beyond this, comparing all pairs of blocks costs more than a sweep, and copies more than they are
// worth.
constexpr std::size_t kMostSegments = 16384;

// The area must exceed this share of the sum of its absolute parts: far more than they lose by
// rounding, whatever their order.
constexpr double kSureShare = 1e-6;

// What a ring must be wider than a sliver, for the two sums to be off by rounding.
constexpr double kSureRatio = 1.1;

bool boxes_meet(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

Box box_of(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

bool is_between(double from, double to, double value) {
  return (from < value && value < to) || (to < value && value < from);
}

}  // namespace

ChainProof ChainProver::chain(std::span<const Segment> segments, bool is_ring) {
  if (segments.size() > kMostSegments) return {};
  take_ends(segments);
  const bool closes = ends_.back() == starts_.front();
  ChainProof proof;
  proof.has_no_spike = has_no_spike(closes);
  if (is_ring) {
    proof.is_sound = closes && is_sound_ring() &&
                     (turns_left_once() || (neighbours_part() && distant_edges_part(true)));
  } else {
    proof.is_sound = !closes && (is_monotone() || (neighbours_part() && distant_edges_part(false)));
  }
  return proof;
}

bool ChainProver::all_apart(std::span<const Segment> segments) {
  if (segments.size() > kMostSegments) return false;
  take_ends(segments);
  return no_pair_meets([](std::size_t, std::size_t) { return false; });
}

void ChainProver::take_ends(std::span<const Segment> segments) {
  starts_.resize(segments.size());
  ends_.resize(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    starts_[i] = segments[i].a;
    ends_[i] = segments[i].b;
  }
}

// Counter-clockwise beyond doubt, and no sliver: the sum of both extents of an edge is at least its
// length.
bool ChainProver::is_sound_ring() const {
  if (edges() < 3) return false;
  const Point origin = starts_[0];
  double twice_area = 0.0, magnitude = 0.0, perimeter_m = 0.0;
  for (std::size_t i = 0; i < edges(); ++i) {
    const Point u = starts_[i] - origin, v = ends_[i] - origin;
    const double left = u.x * v.y, right = u.y * v.x;
    twice_area += left - right;
    magnitude += std::abs(left) + std::abs(right);
    perimeter_m += std::abs(ends_[i].x - starts_[i].x) + std::abs(ends_[i].y - starts_[i].y);
  }
  return in_safe_range(magnitude) && twice_area > kSureShare * magnitude &&
         twice_area > kSureRatio * sliver_width_m_ * perimeter_m;
}

// Left at each corner and once round: a convex polygon. Directions turn by less than half a circle
// at a corner, so that none of them skips the half circle to the left or right: each round changes
// the sign of the edges' x extent twice.
bool ChainProver::turns_left_once() const {
  const std::size_t n = edges();
  std::size_t changes = 0;
  bool was_right = false, first_was_right = false, is_first = true;
  Point before = starts_[n - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const Point corner = starts_[i], after = ends_[i];
    if (sure_sign_of_cross(after - corner, before - corner) <= 0) return false;
    before = corner;
    if (after.x == corner.x) continue;
    const bool is_right = after.x > corner.x;
    if (is_first) {
      first_was_right = is_right;
    } else if (is_right != was_right) {
      ++changes;
    }
    is_first = false;
    was_right = is_right;
  }
  return changes + (was_right != first_was_right ? 1 : 0) == 2;
}

// Ever onwards along one axis.
bool ChainProver::is_monotone() const {
  bool right = true, left = true, up = true, down = true;
  for (std::size_t i = 0; i < edges(); ++i) {
    const Point a = starts_[i], b = ends_[i];
    right = right && b.x > a.x;
    left = left && b.x < a.x;
    up = up && b.y > a.y;
    down = down && b.y < a.y;
  }
  return right || left || up || down;
}

// The two edges of a corner have nothing in common but the corner: they bend there, or go on.
bool ChainProver::corner_parts(Point before, Point corner, Point after) const {
  return is_between(before.x, after.x, corner.x) || is_between(before.y, after.y, corner.y) ||
         sure_sign_of_cross(after - corner, before - corner) != 0;
}

bool ChainProver::neighbours_part() const {
  for (std::size_t i = 1; i < edges(); ++i) {
    if (!corner_parts(starts_[i - 1], starts_[i], ends_[i])) return false;
  }
  const bool closes = ends_.back() == starts_.front();
  return !closes || corner_parts(starts_.back(), starts_.front(), ends_.front());
}

bool ChainProver::distant_edges_part(bool is_closed) {
  const std::size_t last = edges() - 1;
  return no_pair_meets([&](std::size_t i, std::size_t j) {
    return i + 1 == j || (is_closed && i == 0 && j == last);
  });
}

// Both ends of one edge lie beyond doubt on one side of the other.
bool ChainProver::edges_part(std::size_t i, std::size_t j) const {
  const Point a = starts_[i], b = ends_[i], c = starts_[j], d = ends_[j];
  const int side = sure_turn(a, b, c);
  if (side != 0 && side == sure_turn(a, b, d)) return true;
  const int other_side = sure_turn(c, d, a);
  return other_side != 0 && other_side == sure_turn(c, d, b);
}

void ChainProver::make_blocks() {
  boxes_.resize(edges());
  for (std::size_t i = 0; i < edges(); ++i) boxes_[i] = box_of(starts_[i], ends_[i]);
  blocks_.clear();
  for (std::size_t begin = 0; begin < edges(); begin += kBlockSegments) {
    Block block{begin, std::min(begin + kBlockSegments, edges()), kEmptyBox};
    for (std::size_t i = begin; i < block.end; ++i) {
      block.box.add({boxes_[i].min_x, boxes_[i].min_y});
      block.box.add({boxes_[i].max_x, boxes_[i].max_y});
    }
    blocks_.push_back(block);
  }
}

// Pairs for which `may_meet(i, j)`, i < j, holds are not looked at.
template <class MayMeet>
bool ChainProver::no_pair_meets(const MayMeet& may_meet) {
  make_blocks();
  for (std::size_t p = 0; p < blocks_.size(); ++p) {
    for (std::size_t q = p; q < blocks_.size(); ++q) {
      if (!boxes_meet(blocks_[p].box, blocks_[q].box)) continue;
      for (std::size_t i = blocks_[p].begin; i < blocks_[p].end; ++i) {
        const Box box = boxes_[i];
        for (std::size_t j = std::max(i + 1, blocks_[q].begin); j < blocks_[q].end; ++j) {
          if (boxes_meet(box, boxes_[j]) && !may_meet(i, j) && !edges_part(i, j)) return false;
        }
      }
    }
  }
  return true;
}

bool ChainProver::has_no_spike(bool is_closed) const {
  for (std::size_t i = is_closed ? 0 : 1; i < edges(); ++i) {
    const Point corner = starts_[i];
    const Point before = starts_[i == 0 ? edges() - 1 : i - 1];
    if (is_sharp(before - corner, ends_[i] - corner)) return false;
  }
  return true;
}

}  // namespace mapwright::validators
