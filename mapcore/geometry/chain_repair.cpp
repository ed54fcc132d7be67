#include <algorithm>
#include <set>
#include <tuple>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/ring_repair.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright {
namespace {

constexpr int kMostRounds = 8;

bool before(Point p, Point q) {
  return std::tie(p.x, p.y) < std::tie(q.x, q.y);
}

struct PointOrder {
  bool operator()(Point p, Point q) const { return before(p, q); }
};

struct EdgeOrder {
  using Edge = std::pair<Point, Point>;
  bool operator()(const Edge& e, const Edge& f) const {
    return std::tie(e.first.x, e.first.y, e.second.x, e.second.y) <
           std::tie(f.first.x, f.first.y, f.second.x, f.second.y);
  }
};

// The segments' meetings that the chain itself does not explain, as pairs i < j.
std::vector<std::pair<std::size_t, std::size_t>> candidates(std::span<const Point> chain) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    Box box = kEmptyBox;
    box.add(chain[i]);
    box.add(chain[i + 1]);
    boxes.push_back(box);
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); });
  return pairs;
}

// A chain may touch itself (a fence that ends at its own middle) but not cross or retrace itself.
bool meets_wrongly(std::span<const Point> chain, std::size_t i, std::size_t j) {
  const auto kind = meet(chain[i], chain[i + 1], chain[j], chain[j + 1]).kind;
  return kind == Meeting::kOverlap || kind == Meeting::kCross;
}

// Ends of one segment that lie on the other, and the crossing.
void append_cuts(std::span<const Point> chain, std::size_t i, std::size_t j, const Snap& snap,
                 std::vector<std::vector<Point>>& cuts) {
  const auto meeting = meet(chain[i], chain[i + 1], chain[j], chain[j + 1]);
  if (meeting.kind == Meeting::kCross || meeting.kind == Meeting::kTouch) {
    cuts[i].push_back(snap(meeting.at));
    cuts[j].push_back(snap(meeting.at));
    return;
  }
  for (const std::size_t end : {j, j + 1}) {
    if (meet(chain[i], chain[i + 1], chain[end], chain[end]).kind != Meeting::kNone)
      cuts[i].push_back(chain[end]);
  }
  for (const std::size_t end : {i, i + 1}) {
    if (meet(chain[j], chain[j + 1], chain[end], chain[end]).kind != Meeting::kNone)
      cuts[j].push_back(chain[end]);
  }
}

std::vector<Point> noded(std::span<const Point> chain, std::vector<std::vector<Point>>& cuts) {
  std::vector<Point> nodes{chain.front()};
  const auto append = [&](Point p) {
    if (nodes.back() != p) nodes.push_back(p);
  };
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Point from = chain[i];
    std::sort(cuts[i].begin(), cuts[i].end(), [&](Point p, Point q) {
      return squared_length(p - from) < squared_length(q - from);
    });
    for (const Point p : cuts[i]) append(p);
    append(chain[i + 1]);
  }
  return nodes;
}

// Walks the nodes; begins a new piece where a vertex of the piece comes again, and passes over
// edges that were walked before.
std::vector<std::vector<Point>> cut_at_repeats(const std::vector<Point>& nodes) {
  std::vector<std::vector<Point>> pieces;
  std::set<EdgeOrder::Edge, EdgeOrder> walked;
  std::set<Point, PointOrder> in_piece;
  std::vector<Point> piece;
  const auto finish = [&] {
    if (piece.size() > 1) pieces.push_back(piece);
    piece.clear();
    in_piece.clear();
  };
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Point a = nodes[i];
    const Point b = nodes[i + 1];
    const auto edge = before(a, b) ? EdgeOrder::Edge{a, b} : EdgeOrder::Edge{b, a};
    if (!walked.insert(edge).second) {
      finish();
      continue;
    }
    if (piece.empty()) {
      piece.push_back(a);
      in_piece.insert(a);
    }
    piece.push_back(b);
    if (!in_piece.insert(b).second) finish();
  }
  finish();
  return pieces;
}

// A piece that ends at one of its inner vertices: the tail up to there, and the loop.
std::vector<std::vector<Point>> without_lassos(std::vector<std::vector<Point>> pieces) {
  std::vector<std::vector<Point>> result;
  for (auto& piece : pieces) {
    const auto again = std::find(piece.begin(), piece.end() - 1, piece.back());
    if (again == piece.end() - 1 || again == piece.begin()) {
      result.push_back(std::move(piece));
      continue;
    }
    result.emplace_back(piece.begin(), again + 1);
    result.emplace_back(again, piece.end());
  }
  return result;
}

bool is_simple_piece(std::span<const Point> piece) {
  const bool loop = piece.size() > 3 && piece.front() == piece.back();
  return loop ? is_simple_ring(piece.first(piece.size() - 1)) : is_simple_chain(piece);
}

std::vector<std::vector<Point>> cut_once(const std::vector<Point>& chain, const Snap& snap) {
  std::vector<std::vector<Point>> cuts(chain.size());
  for (const auto& [i, j] : candidates(chain)) {
    if (meets_wrongly(chain, i, j)) append_cuts(chain, i, j, snap, cuts);
  }
  return without_lassos(cut_at_repeats(noded(chain, cuts)));
}

}  // namespace

bool is_simple_chain(std::span<const Point> chain) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    if (chain[i] == chain[i + 1]) return false;
  }
  if (chain.size() < 3) return chain.size() == 2;
  for (const auto& [i, j] : candidates(chain)) {
    if (meets_wrongly(chain, i, j)) return false;
  }
  return true;
}

std::optional<std::vector<std::vector<Point>>> simple_chains(std::vector<Point> chain,
                                                             const Snap& snap) {
  std::vector<std::vector<Point>> pieces{std::move(chain)};
  for (int round = 0; round < kMostRounds; ++round) {
    if (std::all_of(pieces.begin(), pieces.end(),
                    [](const auto& piece) { return is_simple_piece(piece); })) {
      return pieces;
    }
    std::vector<std::vector<Point>> next;
    for (const auto& piece : pieces) {
      if (is_simple_piece(piece)) {
        next.push_back(piece);
        continue;
      }
      for (auto& part : cut_once(piece, snap)) next.push_back(std::move(part));
    }
    pieces = std::move(next);
  }
  return std::nullopt;
}

}  // namespace mapwright
