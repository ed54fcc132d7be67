#include "navcore/planning/smoothing.hpp"

#include <algorithm>
#include <utility>

#include "navcore/planning/path.hpp"

namespace mapwright::navcore {
namespace {

// How many vertices ahead pruning looks for one in sight.
constexpr std::size_t kLookAhead = 64;

// Passes over all corners, and the least share of a leg that is cut off: after six passes of
// halving hardly a corner is left that is worth another.
constexpr int kCornerPasses = 6;
constexpr double kLeastCut = 1.0 / 64.0;

// A point along a path: on the leg that ends at vertex `leg`.
struct Station {
  Point at;
  std::size_t leg = 1;
};

class Smoother {
 public:
  Smoother(const FreeSpace& space, std::vector<Point> path, double radius_m,
           double extra_clearance_m)
      : space_(space),
        path_(std::move(path)),
        radius_m_(radius_m),
        shortcut_radius_m_(radius_m + extra_clearance_m) {}

  // From each vertex goes on to the farthest that it sees.
  void prune() {
    std::vector<Point> pruned{path_.front()};
    for (std::size_t i = 0; i + 1 < path_.size();) {
      std::size_t next = std::min(i + kLookAhead, path_.size() - 1);
      while (next > i + 1 && !is_shortcut(path_[i], path_[next])) --next;
      pruned.push_back(path_[next]);
      i = next;
    }
    keep_if_shorter(std::move(pruned));
  }

  // Joins two random points along the path.
  void cut_at_random(Random& random) {
    const double length_m = path_length_m(path_);
    double first_m = random.uniform(0.0, length_m);
    double second_m = random.uniform(0.0, length_m);
    if (second_m < first_m) std::swap(first_m, second_m);
    const Station first = station(first_m);
    const Station second = station(second_m);
    if (first.leg < second.leg) cut(first, second);
  }

  // Cuts each corner as far from its vertex as it can, halving the distance until the cut is free.
  void cut_corners() {
    for (std::size_t leg = 1; leg + 1 < path_.size(); ++leg) {
      const Point before = path_[leg - 1], corner = path_[leg], after = path_[leg + 1];
      const std::size_t size = path_.size();
      for (double share = 0.5; share >= kLeastCut && path_[leg] == corner; share *= 0.5) {
        cut({corner + share * (before - corner), leg},
            {corner + share * (after - corner), leg + 1});
      }
      leg += path_.size() - size;  // over the vertex that the cut has added
    }
  }

  std::vector<Point> take() { return std::move(path_); }

 private:
  bool is_shortcut(Point a, Point b) const {
    return space_.is_free(a, shortcut_radius_m_) && space_.is_free(b, shortcut_radius_m_) &&
           space_.is_free_way(a, b, shortcut_radius_m_);
  }

  // A point on a leg is rounded, so what remains of the leg is another one and checked again.
  bool is_rest_free(Point a, Point b) const {
    return space_.is_free(b, radius_m_) && space_.is_free(a, radius_m_) &&
           space_.is_free_way(a, b, radius_m_);
  }

  void cut(const Station& first, const Station& second) {
    if (!is_shortcut(first.at, second.at) || !is_rest_free(path_[first.leg - 1], first.at) ||
        !is_rest_free(second.at, path_[second.leg])) {
      return;
    }
    std::vector<Point> shorter(path_.begin(), path_.begin() + static_cast<long>(first.leg));
    for (const Point p : {first.at, second.at}) {
      if (p != shorter.back()) shorter.push_back(p);
    }
    if (shorter.back() == path_[second.leg]) shorter.pop_back();
    shorter.insert(shorter.end(), path_.begin() + static_cast<long>(second.leg), path_.end());
    keep_if_shorter(std::move(shorter));
  }

  void keep_if_shorter(std::vector<Point> other) {
    if (path_length_m(other) <= path_length_m(path_)) path_ = std::move(other);
  }

  Station station(double along_m) const {
    for (std::size_t leg = 1; leg < path_.size(); ++leg) {
      const double leg_m = distance(path_[leg - 1], path_[leg]);
      if (along_m < leg_m) {
        return {path_[leg - 1] + (along_m / leg_m) * (path_[leg] - path_[leg - 1]), leg};
      }
      along_m -= leg_m;
    }
    return {path_.back(), path_.size() - 1};
  }

  const FreeSpace& space_;
  std::vector<Point> path_;
  double radius_m_;
  double shortcut_radius_m_;
};

}  // namespace

std::vector<Point> smooth_path(const FreeSpace& space, std::vector<Point> path, double radius_m,
                               const SmoothingOptions& options, Random& random) {
  if (path.size() <= 2) return path;
  const std::size_t tries = options.tries + path.size();
  Smoother smoother(space, std::move(path), radius_m, options.extra_clearance_m);
  smoother.prune();
  for (std::size_t i = 0; i < tries; ++i) smoother.cut_at_random(random);
  smoother.prune();
  for (int i = 0; i < kCornerPasses; ++i) {
    smoother.cut_corners();
    smoother.prune();
  }
  return smoother.take();
}

}  // namespace mapwright::navcore
