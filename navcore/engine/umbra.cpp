#include "navcore/engine/umbra.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mapwright::navcore::engine {
namespace {

// What is nearer to a line than this (metres) counts as on it.
constexpr double kClear_m = 1e-9;

// The direction from a corner past `end` that lies furthest to the left, or to the right.
Point innermost(Point end, const Square& square, bool leftmost) {
  const auto corners = square.corners();
  Point best = end - corners[0];
  for (const Point corner : corners) {
    const Point direction = end - corner;
    const double turn = cross(best, direction);
    if (leftmost ? turn > 0.0 : turn < 0.0) best = direction;
  }
  return best;
}

// Odd-even rule for the origin in the polygon chain + chord. Requires that no edge of the chain
// meets the square around the origin.
bool surrounds_origin(std::span<const Point> polygon) {
  bool inside = false;
  Point p = polygon.back();
  for (const Point q : polygon) {
    if ((p.y > 0.0) != (q.y > 0.0) && (cross(p, q) > 0.0) == (q.y > p.y)) inside = !inside;
    p = q;
  }
  return inside;
}

bool keeps_clear(std::span<const Point> chain, const Square& square) {
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (square.meets(chain[i - 1], chain[i])) return false;
  }
  return true;
}

// The vertex furthest behind the chord as seen from the square; 0 where none is behind it.
std::size_t furthest_behind(std::span<const Point> chain, Point a, Point b) {
  std::size_t furthest = 0;
  double most = -1e-3 * kClear_m * distance(a, b);
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const double side = side_of_line(a, b, chain[i]);
    if (side < most) {
      most = side;
      furthest = i;
    }
  }
  return furthest;
}

void add_chords(std::span<const Point> chain, const Square& square, std::vector<Umbra>& umbras) {
  if (chain.size() < 3) return;
  Point a = chain.front();
  Point b = chain.back();
  const Square::Side side = square.side(a, b);
  if (side == Square::Side::kBoth) return;
  if (side == Square::Side::kRight) std::swap(a, b);
  if (const std::size_t split = furthest_behind(chain, a, b)) {
    add_chords(chain.first(split + 1), square, umbras);
    add_chords(chain.subspan(split), square, umbras);
    return;
  }
  if (surrounds_origin(chain)) return;
  if (const auto umbra = Umbra::of(a, b, square)) umbras.push_back(*umbra);
}

// Positions of the vertices seen furthest to the right and to the left from the origin, angles
// followed along the chain.
std::pair<std::size_t, std::size_t> silhouette(std::span<const Point> chain) {
  std::pair<std::size_t, std::size_t> ends{0, 0};
  double angle = 0.0, least = 0.0, most = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    angle += std::atan2(cross(chain[i - 1], chain[i]), dot(chain[i - 1], chain[i]));
    if (angle < least) {
      least = angle;
      ends.first = i;
    }
    if (angle > most) {
      most = angle;
      ends.second = i;
    }
  }
  return ends;
}

}  // namespace

std::optional<Umbra> Umbra::of(Point a, Point b, const Square& square) {
  const double clear = kClear_m * distance(a, b);
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Point corner : square.corners()) {
    const double side = side_of_line(a, b, corner);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least <= clear && most >= -clear) return std::nullopt;
  if (most < 0.0) std::swap(a, b);
  Umbra umbra;
  umbra.a_ = a;
  umbra.b_ = b;
  umbra.past_a_ = innermost(a, square, true);
  umbra.past_b_ = innermost(b, square, false);
  umbra.clear_ = clear;
  umbra.apparent_size_ = cross(a, b) / (length(a) * length(b));
  return umbra;
}

void add_chord_umbras(std::span<const Point> chain, const Square& square,
                      std::vector<Umbra>& umbras) {
  if (chain.size() < 3 || !keeps_clear(chain, square)) return;
  const auto [right, left] = silhouette(chain);
  const auto [first, last] = std::minmax(right, left);
  add_chords(chain.subspan(first, last - first + 1), square, umbras);
  if (chain.front() != chain.back()) return;
  // A closed chain has a second way from one silhouette vertex to the other.
  std::vector<Point> rest(chain.begin() + static_cast<std::ptrdiff_t>(last), chain.end());
  rest.insert(rest.end(), chain.begin() + 1,
              chain.begin() + static_cast<std::ptrdiff_t>(first) + 1);
  add_chords(rest, square, umbras);
}

}  // namespace mapwright::navcore::engine
