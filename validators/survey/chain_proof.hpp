// Private to this folder: Proofs, in doubles and at one look, that a chain of segments is sound.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// What `ChainProver` found out about an obstacle's segments. Each `true` is proven; `false` says
/// that it is not so, or that a closer look must tell.
struct ChainProof {
  /// A closed chain: a simple ring, counter-clockwise, wider on average than a sliver. An open one:
  /// no two segments have a point in common but neighbours their common end. Other segments
  /// (stairs): no two have any point in common.
  bool is_sound = false;
  bool has_no_spike = false;  ///< no corner is as sharp as a spike's
};

/// Proves what it can about one obstacle after another; keeps its memory from one to the next.
class ChainProver {
 public:
  /// `sliver_width_m`: a ring must be wider on average.
  explicit ChainProver(double sliver_width_m) : sliver_width_m_(sliver_width_m) {}

  /// A joined chain of segments that all have a length; closed where the last one ends at the
  /// beginning of the first. `is_ring`: it must be a sound ring, else an open chain will do.
  ChainProof chain(std::span<const Segment> segments, bool is_ring);

  /// Segments without order: no two of them meet.
  bool all_apart(std::span<const Segment> segments);

 private:
  /// A run of segments that follow each other, and the box around them.
  struct Block {
    std::size_t begin, end;
    Box box;
  };

  /// What a walk over the corners shows. Each `true` is proven.
  struct Corners {
    bool turn_left_once = false;  ///< a convex polygon
    bool part = true;             ///< edges have no more than their corner in common
    bool are_blunt = true;        ///< none is as sharp as a spike's
  };

  bool is_sound_ring() const;
  bool is_monotone() const;
  Corners look_at_corners(bool is_closed) const;
  bool distant_edges_part(bool is_closed);
  bool edges_part(std::size_t i, std::size_t j) const;
  template <class MayMeet>
  bool no_pair_meets(const MayMeet& may_meet);
  template <class MayMeet>
  bool no_pair_meets(const Block& p, const Block& q, const MayMeet& may_meet) const;
  void make_blocks();

  std::size_t edges() const { return segments_.size(); }
  Point start(std::size_t i) const { return segments_[i].a; }
  Point end(std::size_t i) const { return segments_[i].b; }

  double sliver_width_m_;
  std::span<const Segment> segments_;  // looked at now
  std::vector<Box> boxes_;             // of the segments
  std::vector<Block> blocks_;
};

}  // namespace mapwright::validators
