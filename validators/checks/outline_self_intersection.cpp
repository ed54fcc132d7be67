#include <algorithm>
#include <tuple>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Up to this many segments, trying every pair costs less than searching.
constexpr std::size_t kFewSegments = 32;

// Two segments of an obstacle, 0-based, earlier < later, and how they meet.
struct SelfMeeting {
  std::size_t earlier, later;
  SegmentMeeting meeting;
};

// The segments of one obstacle that have a length, and which of them follow each other.
class Chain {
 public:
  explicit Chain(const Obstacle& obstacle) : obstacle_(obstacle) {
    for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
      if (segment(k).a != segment(k).b) segments_.push_back(k);
    }
  }

  std::vector<SelfMeeting> defects() const {
    std::vector<SelfMeeting> found;
    for_each_pair([&](std::size_t p, std::size_t q) {
      const Segment& s = segment(segments_[p]);
      const Segment& t = segment(segments_[q]);
      const auto meeting = meet(s.a, s.b, t.a, t.b);
      if (is_defect(p, q, meeting)) found.push_back({segments_[p], segments_[q], meeting});
    });
    std::sort(found.begin(), found.end(), [](const SelfMeeting& m, const SelfMeeting& n) {
      return std::tie(m.later, m.earlier) < std::tie(n.later, n.earlier);
    });
    return found;
  }

 private:
  const Segment& segment(std::size_t k) const { return obstacle_.segments[k]; }

  // Pairs p < q of segments that meet, and maybe others.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    if (segments_.size() > kFewSegments) return for_each_meeting_pair_of_many(visit);
    for (std::size_t q = 1; q < segments_.size(); ++q) {
      for (std::size_t p = 0; p < q; ++p) visit(p, q);
    }
  }

  // By the segments and not by their boxes: the teeth of a slanting comb have boxes that all meet.
  template <class Visit>
  void for_each_meeting_pair_of_many(const Visit& visit) const {
    std::vector<IndexedSegment> indexed;
    indexed.reserve(segments_.size());
    for (const std::size_t k : segments_) indexed.push_back({segment(k).a, segment(k).b, 0});
    const SegmentIndex index(std::move(indexed));
    for (std::size_t q = 1; q < segments_.size(); ++q) {
      const Segment& s = segment(segments_[q]);
      index.query_meeting(s.a, s.b, [&](std::size_t p) {
        if (p < q) visit(p, q);
        return true;
      });
    }
  }

  bool are_neighbours(std::size_t p, std::size_t q) const {
    return p + 1 == q || (p == 0 && q + 1 == segments_.size());
  }

  // Stairs may fan out from one point and their closing segment may lie on the top step; open
  // chains have no inside that a touching point would spoil.
  bool is_defect(std::size_t p, std::size_t q, const SegmentMeeting& meeting) const {
    switch (meeting.kind) {
      case Meeting::kNone:
        return false;
      case Meeting::kCross:
        return true;
      case Meeting::kTouch:
        return is_closed(obstacle_.shape_type) && !are_neighbours(p, q);
      case Meeting::kOverlap:
        return obstacle_.shape_type != ShapeType::kStairs && !is_twice(p, q);
    }
    return false;
  }

  // G111 tells of those.
  bool is_twice(std::size_t p, std::size_t q) const {
    const Segment& s = segment(segments_[p]);
    const Segment& t = segment(segments_[q]);
    const bool same = s.a == t.a && s.b == t.b;
    const bool reversed = s.a == t.b && s.b == t.a;
    return same || (reversed && is_open_chain(obstacle_.shape_type));
  }

  const Obstacle& obstacle_;
  std::vector<std::size_t> segments_;
};

std::string verb(Meeting kind) {
  switch (kind) {
    case Meeting::kCross:
      return " crosses";
    case Meeting::kOverlap:
      return " overlaps";
    default:
      return " touches";
  }
}

std::string advice(Meeting kind) {
  return kind == Meeting::kTouch ? "; move the vertex away, or make two obstacles of it"
                                 : "; put the corners in the order in which they follow";
}

void report(const Obstacle& obstacle, std::size_t i, const SelfMeeting& m, FindingSink& sink) {
  sink.segment(FindingCode::G104, i, m.later, SegmentField::kAx, m.meeting.at,
               name_of(obstacle, m.later) + verb(m.meeting.kind) + " segment " +
                   std::to_string(m.earlier + 1) + " at " + place_text(m.meeting.at) +
                   advice(m.meeting.kind));
  const Segment &earlier = obstacle.segments[m.earlier], &later = obstacle.segments[m.later];
  sink.geometry() = {{m.meeting.at}, {{earlier.a, earlier.b}, {later.a, later.b}}, {}};
}

// Where vertices meet, up to four pairs of segments share the point: told once.
void check_obstacle(const Obstacle& obstacle, std::size_t i, FindingSink& sink) {
  std::vector<Point> reported;
  for (const auto& m : Chain(obstacle).defects()) {
    const bool is_known =
        m.meeting.kind == Meeting::kTouch &&
        std::find(reported.begin(), reported.end(), m.meeting.at) != reported.end();
    if (is_known) continue;
    reported.push_back(m.meeting.at);
    report(obstacle, i, m, sink);
  }
}

}  // namespace

void check_outline_self_intersection(const CheckContext& context, FindingSink& sink) {
  for_each_suspect_chain(
      context, [&](const Obstacle& obstacle, std::size_t i) { check_obstacle(obstacle, i, sink); });
}

}  // namespace mapwright::validators
