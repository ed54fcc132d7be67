#include "bench/support/random_rings.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace mapwright::bench {
namespace {

using Ring = std::vector<Point>;

double on_grid(Random& random, std::uint64_t n) {
  return static_cast<double>(random.below(n));
}

// Even whole numbers, so that middles of edges are exact. Star-shaped around (0, 0), hence simple
// but for what rounding does.
Ring star(Random& random, std::size_t corners, double reach) {
  Ring ring;
  for (std::size_t i = 0; i < corners; ++i) {
    const double bearing = 2.0 * std::numbers::pi *
                           (static_cast<double>(i) + random.uniform(0.0, 0.7)) /
                           static_cast<double>(corners);
    const double r = reach * random.uniform(0.4, 1.0);
    ring.push_back({2.0 * std::round(0.5 * r * std::cos(bearing)),
                    2.0 * std::round(0.5 * r * std::sin(bearing))});
  }
  return ring;
}

Ring small_star(Random& random) {
  return star(random, 4 + random.below(6), 40.0);
}

Point middle(const Ring& ring, std::size_t k) {
  return 0.5 * (ring[k] + ring[k + 1 == ring.size() ? 0 : k + 1]);
}

void insert_at(Ring& ring, std::size_t k, Point p) {
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k), p);
}

Ring small_grid(Random& random) {
  const std::uint64_t side = 3 + random.below(4);
  Ring ring(3 + random.below(6));
  for (auto& p : ring) p = {on_grid(random, side), on_grid(random, side)};
  return ring;
}

// y = slope x + 0 or 1.
Ring collinear(Random& random) {
  const double slope = 0.25 * on_grid(random, 5);
  const double offset = random.below(3) == 0 ? 0.0 : 1.0;
  Ring ring(3 + random.below(5));
  for (auto& p : ring) {
    const double x = on_grid(random, 8);
    p = {x, slope * x + (random.below(2) == 0 ? offset : 0.0)};
  }
  return ring;
}

Ring repeated(Random& random) {
  Ring ring = small_star(random);
  const std::size_t k = random.below(ring.size());
  const bool in_a_row = random.below(2) == 0;
  insert_at(ring, in_a_row ? k : random.below(ring.size() + 1), ring[k]);
  if (random.below(4) == 0) insert_at(ring, random.below(ring.size() + 1), ring.back());
  return ring;
}

Ring touching(Random& random) {
  Ring ring = small_star(random);
  const Point at = middle(ring, random.below(ring.size()));
  const std::size_t k = random.below(ring.size());
  random.below(2) == 0 ? insert_at(ring, k, at) : void(ring[k] = at);
  return ring;
}

Ring spiked(Random& random) {
  Ring ring = small_star(random);
  const std::size_t k = random.below(ring.size());
  const Point foot = random.below(2) == 0 ? middle(ring, k) : ring[k];
  const Point tip = foot + Point{on_grid(random, 9) - 4.0, on_grid(random, 9) - 4.0};
  const std::size_t at = k + 1;
  insert_at(ring, at, foot);
  insert_at(ring, at, tip);
  insert_at(ring, at, foot);
  if (random.below(2) == 0) ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  return ring;
}

double nudged(double value, Random& random) {
  const auto steps = random.below(3);
  for (std::uint64_t i = 0; i < steps; ++i) {
    value = std::nextafter(value, random.below(2) == 0 ? HUGE_VAL : -HUGE_VAL);
  }
  return value;
}

Ring almost_touching(Random& random) {
  Ring ring = touching(random);
  const double scale = random.uniform(0.01, 1.0);
  const Point by{random.uniform(-100.0, 100.0), random.uniform(-100.0, 100.0)};
  for (auto& p : ring) {
    p = scale * p + by;
    p = {nudged(p.x, random), nudged(p.y, random)};
  }
  return ring;
}

Ring many_vertices(Random& random) {
  Ring ring = star(random, 20 + random.below(61), 4000.0);
  switch (random.below(4)) {
    case 0:
      std::swap(ring[random.below(ring.size())], ring[random.below(ring.size())]);
      break;
    case 1:
      ring[random.below(ring.size())] = middle(ring, random.below(ring.size()));
      break;
    case 2:
      insert_at(ring, random.below(ring.size()), ring[random.below(ring.size())]);
      break;
    default:
      break;
  }
  return ring;
}

Ring far_away(Random& random) {
  Ring ring = star(random, 3 + random.below(12), 20000.0);
  for (auto& p : ring) p = {425800.0 + p.x / 1000.0, 4582230.0 + p.y / 1000.0};
  if (random.below(3) == 0) {
    std::swap(ring[random.below(ring.size())], ring[random.below(ring.size())]);
  }
  if (random.below(3) == 0)
    ring[random.below(ring.size())] = middle(ring, random.below(ring.size()));
  return ring;
}

}  // namespace

std::string_view to_string(RingKind kind) {
  static constexpr std::array<std::string_view, kRingKinds> kNames{
      "on a small grid", "on two lines",    "vertices repeated", "touching itself",
      "with a spike",    "almost touching", "many vertices",     "millimetres in UTM"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Point> random_ring(RingKind kind, Random& random) {
  switch (kind) {
    case RingKind::kSmallGrid:
      return small_grid(random);
    case RingKind::kCollinear:
      return collinear(random);
    case RingKind::kRepeated:
      return repeated(random);
    case RingKind::kTouching:
      return touching(random);
    case RingKind::kSpiked:
      return spiked(random);
    case RingKind::kAlmostTouching:
      return almost_touching(random);
    case RingKind::kManyVertices:
      return many_vertices(random);
    case RingKind::kFarAway:
      return far_away(random);
  }
  return {};
}

}  // namespace mapwright::bench
