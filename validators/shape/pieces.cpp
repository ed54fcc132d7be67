#include "validators/shape/pieces.hpp"

namespace mapwright::validators {
namespace {

double position(const Segment& segment, Point p) {
  const Point ab = segment.b - segment.a;
  return std::clamp(dot(p - segment.a, ab) / squared_length(ab), 0.0, 1.0);
}

bool lies_on(const Segment& segment, Point p) {
  return meet(p, p, segment.a, segment.b).kind != Meeting::kNone;
}

}  // namespace

void add_cuts(const Segment& segment, const Segment& edge, std::uint32_t obstacle,
              std::uint32_t number, std::vector<Cut>& cuts) {
  const auto add = [&](Point p) { cuts.push_back({position(segment, p), p, obstacle, number}); };
  const auto meeting = meet(segment.a, segment.b, edge.a, edge.b);
  if (meeting.kind == Meeting::kNone) return;
  if (meeting.kind != Meeting::kOverlap) {
    add(meeting.at);
    return;
  }
  for (const Point p : {edge.a, edge.b}) {
    if (lies_on(segment, p)) add(p);
  }
  for (const Point p : {segment.a, segment.b}) {
    if (lies_on(edge, p)) add(p);
  }
}

std::vector<Piece> pieces_of(const Segment& segment, std::vector<Cut>& cuts) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& p, const Cut& q) {
    return p.t != q.t                 ? p.t < q.t
           : p.obstacle != q.obstacle ? p.obstacle < q.obstacle
                                      : p.edge < q.edge;
  });
  std::vector<Piece> pieces;
  Point from = segment.a;
  std::optional<Cut> last;
  for (const Cut& cut : cuts) {
    if (cut.at != from) pieces.push_back({from, cut.at, last, cut});
    if (cut.at != from || !last) last = cut;
    from = cut.at;
  }
  if (from != segment.b) pieces.push_back({from, segment.b, last, std::nullopt});
  return pieces;
}

}  // namespace mapwright::validators
