#include "navcore/localization/pose_estimate.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace mapwright::navcore {
namespace {

// The mode is sought in a grid of poses: the heaviest 3 × 3 × 3 cells around one of the heaviest
// cells, then the window moves to its own mean until it rests.
constexpr double kCell_m = 0.5;
constexpr double kCell_deg = 10.0;
constexpr std::int64_t kHeadings = 36;
constexpr std::size_t kCandidates = 32;
constexpr int kShifts = 5;

struct Cell {
  std::int64_t x, y, heading;
  double weight;

  auto key() const { return std::array{x, y, heading}; }
};

bool by_place(const Cell& p, const Cell& q) {
  return p.key() < q.key();
}

std::int64_t cell_number(double value, double size) {
  return static_cast<std::int64_t>(std::floor(value / size));
}

Cell cell_of(const Pose& pose, double weight) {
  const std::int64_t turn = cell_number(pose.theta.wrapped().degrees(), kCell_deg);
  return {cell_number(pose.x, kCell_m), cell_number(pose.y, kCell_m),
          (turn + kHeadings) % kHeadings, weight};
}

// Cells that hold weight, in order of place.
std::vector<Cell> occupied_cells(const ParticleSet& particles) {
  std::vector<Cell> cells;
  cells.reserve(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    cells.push_back(cell_of(particles.poses[i], particles.weights[i]));
  }
  std::stable_sort(cells.begin(), cells.end(), by_place);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].key() == cells[kept].key()) {
      cells[kept].weight += cells[i].weight;
    } else {
      cells[++kept] = cells[i];
    }
  }
  cells.resize(kept + 1);
  return cells;
}

double weight_around(const std::vector<Cell>& cells, const Cell& centre) {
  double sum = 0.0;
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t turn = -1; turn <= 1; ++turn) {
        const Cell wanted{centre.x + dx, centre.y + dy,
                          (centre.heading + turn + kHeadings) % kHeadings, 0.0};
        const auto found = std::lower_bound(cells.begin(), cells.end(), wanted, by_place);
        if (found != cells.end() && found->key() == wanted.key()) sum += found->weight;
      }
    }
  }
  return sum;
}

// Middle of the cell with the heaviest surroundings.
Pose heaviest_place(const std::vector<Cell>& cells) {
  std::vector<Cell> heaviest = cells;
  const std::size_t count = std::min(kCandidates, heaviest.size());
  std::partial_sort(heaviest.begin(), heaviest.begin() + static_cast<std::ptrdiff_t>(count),
                    heaviest.end(), [](const Cell& p, const Cell& q) {
                      return p.weight != q.weight ? p.weight > q.weight : by_place(p, q);
                    });
  double best_weight = -1.0;
  Cell best{};
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weight_around(cells, heaviest[i]);
    if (weight > best_weight) {
      best_weight = weight;
      best = heaviest[i];
    }
  }
  const auto middle = [](std::int64_t cell, double size) {
    return (static_cast<double>(cell) + 0.5) * size;
  };
  return {middle(best.x, kCell_m), middle(best.y, kCell_m),
          Angle::from_degrees(middle(best.heading, kCell_deg))};
}

/// Sums over the particles in the window around a pose.
struct Window {
  double weight = 0.0;
  Point position;          ///< mean
  Angle heading;           ///< mean
  double squared_m = 0.0;  ///< mean squared distance from the window's pose
  double squared_rad = 0.0;
};

Window look_around(const ParticleSet& particles, const Pose& centre) {
  const double limit = Angle::from_degrees(kModeHeading_deg).radians();
  Window window;
  double turn_sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Point way = particles.poses[i].position() - centre.position();
    const double squared = squared_length(way);
    if (squared > kModeRadius_m * kModeRadius_m) continue;
    const double turn = (particles.poses[i].theta - centre.theta).wrapped().radians();
    if (std::abs(turn) > limit) continue;
    const double w = particles.weights[i];
    window.weight += w;
    window.position = window.position + w * way;
    turn_sum += w * turn;
    window.squared_m += w * squared;
    window.squared_rad += w * turn * turn;
  }
  if (window.weight <= 0.0) return {0.0, centre.position(), centre.theta, 0.0, 0.0};
  const double scale = 1.0 / window.weight;
  window.position = centre.position() + scale * window.position;
  window.heading = (centre.theta + Angle::from_radians(scale * turn_sum)).wrapped();
  window.squared_m *= scale;
  window.squared_rad *= scale;
  return window;
}

double spread_around(const ParticleSet& particles, Point centre) {
  double sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    sum += particles.weights[i] * squared_length(particles.poses[i].position() - centre);
  }
  return std::sqrt(sum);
}

}  // namespace

PoseEstimate estimate_pose(const ParticleSet& particles) {
  assert(particles.size() > 0);
  Pose centre = heaviest_place(occupied_cells(particles));
  for (int i = 0; i < kShifts; ++i) {
    const Window window = look_around(particles, centre);
    centre = {window.position.x, window.position.y, window.heading};
  }
  const Window window = look_around(particles, centre);
  return {centre, window.weight, std::sqrt(window.squared_m),
          Angle::from_radians(std::sqrt(window.squared_rad)),
          spread_around(particles, centre.position())};
}

double share_within(const ParticleSet& particles, const Pose& pose, double limit_m,
                    double limit_deg) {
  double share = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose& p = particles.poses[i];
    const bool near = distance(p.position(), pose.position()) <= limit_m &&
                      std::abs((p.theta - pose.theta).wrapped().degrees()) <= limit_deg;
    if (near) share += particles.weights[i];
  }
  return share;
}

double share_around(const ParticleSet& particles, const Pose& pose) {
  return look_around(particles, pose).weight;
}

}  // namespace mapwright::navcore
