#include "validators/survey/chain_proof.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

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

// All four at once: which of them fails, no processor foresees.
bool boxes_meet(const Box& p, const Box& q) {
  const int in_x = (p.min_x <= q.max_x ? 1 : 0) & (q.min_x <= p.max_x ? 1 : 0);
  const int in_y = (p.min_y <= q.max_y ? 1 : 0) & (q.min_y <= p.max_y ? 1 : 0);
  return (in_x & in_y) != 0;
}

Box box_of(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

bool is_between(double from, double to, double value) {
  return (from < value && value < to) || (to < value && value < from);
}

bool goes_on(Point before, Point corner, Point after) {
  return is_between(before.x, after.x, corner.x) || is_between(before.y, after.y, corner.y);
}

// Counts how often the edges of a ring change between right and left.
class RoundCounter {
 public:
  void add(double extent_x) {
    if (extent_x == 0.0) return;
    // From its sign bit: a comparison would be guessed, and wrongly half of the time.
    const int side = 1 + static_cast<int>(std::bit_cast<std::uint64_t>(extent_x) >> 63U);
    changes_ += side != last_ ? 1 : 0;
    first_ = first_ == 0 ? side : first_;
    last_ = side;
  }
  /// The first edge counts as a change too.
  bool is_one() const { return changes_ - 1 + (last_ != first_ ? 1 : 0) == 2; }

 private:
  int changes_ = 0, first_ = 0, last_ = 0;
};

}  // namespace

ChainProof ChainProver::chain(std::span<const Segment> segments, bool is_ring) {
  if (segments.size() > kMostSegments) return {};
  segments_ = segments;
  const bool closes = end(edges() - 1) == start(0);
  const Corners corners = look_at_corners(closes);
  ChainProof proof;
  proof.has_no_spike = corners.are_blunt;
  if (is_ring) {
    proof.is_sound = closes && is_sound_ring() &&
                     (corners.turn_left_once || (corners.part && distant_edges_part(true)));
  } else {
    proof.is_sound = !closes && (is_monotone() || (corners.part && distant_edges_part(false)));
  }
  return proof;
}

bool ChainProver::all_apart(std::span<const Segment> segments) {
  if (segments.size() > kMostSegments) return false;
  segments_ = segments;
  return no_pair_meets([](std::size_t, std::size_t) { return false; });
}

// Counter-clockwise beyond doubt, and no sliver: the sum of both extents of an edge is at least its
// length.
bool ChainProver::is_sound_ring() const {
  if (edges() < 3) return false;
  const Point origin = start(0);
  double twice_area = 0.0, magnitude = 0.0, perimeter_m = 0.0;
  for (std::size_t i = 0; i < edges(); ++i) {
    const Point u = start(i) - origin, v = end(i) - origin;
    const double left = u.x * v.y, right = u.y * v.x;
    twice_area += left - right;
    magnitude += std::abs(left) + std::abs(right);
    perimeter_m += std::abs(end(i).x - start(i).x) + std::abs(end(i).y - start(i).y);
  }
  return in_safe_range(magnitude) && twice_area > kSureShare * magnitude &&
         twice_area > kSureRatio * sliver_width_m_ * perimeter_m;
}

// Left at each corner and once round: a convex polygon. Directions turn by less than half a circle
// at a corner, so that none of them skips the half circle to the left or right: each round changes
// the sign of the edges' x extent twice.
//
// The two edges of a corner have nothing in common but the corner where they bend there, or go on.
ChainProver::Corners ChainProver::look_at_corners(bool is_closed) const {
  const std::size_t n = edges();
  Corners corners;
  bool all_left = is_closed;
  RoundCounter rounds;
  Point before = start(is_closed ? n - 1 : 0);
  for (std::size_t i = is_closed ? 0 : 1; i < n; ++i) {
    const Point corner = start(i), after = end(i);
    const Point onwards = after - corner, back = before - corner;
    const int side = sure_sign_of_cross(onwards, back);
    all_left = all_left && side > 0;
    if (side == 0 && !goes_on(before, corner, after)) corners.part = false;
    if (is_sharp(back, onwards)) corners.are_blunt = false;
    rounds.add(onwards.x);
    before = corner;
  }
  corners.turn_left_once = all_left && rounds.is_one();
  return corners;
}

// Ever onwards along one axis.
bool ChainProver::is_monotone() const {
  bool right = true, left = true, up = true, down = true;
  for (std::size_t i = 0; i < edges(); ++i) {
    const Point a = start(i), b = end(i);
    right = right && b.x > a.x;
    left = left && b.x < a.x;
    up = up && b.y > a.y;
    down = down && b.y < a.y;
  }
  return right || left || up || down;
}

bool ChainProver::distant_edges_part(bool is_closed) {
  const std::size_t last = edges() - 1;
  return no_pair_meets([&](std::size_t i, std::size_t j) {
    return i + 1 == j || (is_closed && i == 0 && j == last);
  });
}

// Both ends of one edge lie beyond doubt on one side of the other.
bool ChainProver::edges_part(std::size_t i, std::size_t j) const {
  const Point a = start(i), b = end(i), c = start(j), d = end(j);
  const int side = sure_turn(a, b, c);
  if (side != 0 && side == sure_turn(a, b, d)) return true;
  const int other_side = sure_turn(c, d, a);
  return other_side != 0 && other_side == sure_turn(c, d, b);
}

void ChainProver::make_blocks() {
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
  boxes_.resize(edges());
  for (std::size_t i = 0; i < edges(); ++i) boxes_[i] = box_of(start(i), end(i));
  if (edges() <= kBlockSegments) return no_pair_meets({0, edges(), {}}, {0, edges(), {}}, may_meet);
  make_blocks();
  for (std::size_t p = 0; p < blocks_.size(); ++p) {
    for (std::size_t q = p; q < blocks_.size(); ++q) {
      if (!boxes_meet(blocks_[p].box, blocks_[q].box)) continue;
      if (!no_pair_meets(blocks_[p], blocks_[q], may_meet)) return false;
    }
  }
  return true;
}

template <class MayMeet>
bool ChainProver::no_pair_meets(const Block& p, const Block& q, const MayMeet& may_meet) const {
  for (std::size_t i = p.begin; i < p.end; ++i) {
    const Box box = boxes_[i];
    for (std::size_t j = std::max(i + 1, q.begin); j < q.end; ++j) {
      if (boxes_meet(box, boxes_[j]) && !may_meet(i, j) && !edges_part(i, j)) return false;
    }
  }
  return true;
}

}  // namespace mapwright::validators
