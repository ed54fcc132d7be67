#include "navcore/engine/single_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "navcore/engine/iso_line.hpp"
#include "navcore/engine/near_line.hpp"

namespace mapwright::navcore::engine {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

class SingleRay {
 public:
  SingleRay(const Scene& scene, Point origin, Point direction, double height_m, double max_range_m)
      : scene_(scene),
        origin_(origin),
        direction_(direction),
        height_m_(height_m),
        range_m_(max_range_m) {}

  /// Visits the bins along the ray, column by column (or row by row), nearest first: in each column
  /// the rows that the ray passes there.
  double cast() {
    const ItemBins& bins = scene_.bins();
    if (bins.is_empty()) return range_m_;
    steep_ = std::abs(direction_.y) > std::abs(direction_.x);
    const double rate = along(direction_);
    const std::int32_t last = rate > 0.0 ? count() - 1 : 0;
    const std::int32_t step = rate > 0.0 ? 1 : -1;
    for (std::int32_t i = column_at(0.0); (last - i) * step >= 0; i += step) {
      const double enter = time_at(rate > 0.0 ? i : i + 1) - kSlack * bins.bin_size_m();
      const double leave = time_at(rate > 0.0 ? i + 1 : i) + kSlack * bins.bin_size_m();
      if (enter > range_m_) break;
      visit_column(i, std::max(0.0, enter), std::clamp(leave, 0.0, range_m_));
    }
    return range_m_;
  }

 private:
  static constexpr double kSlack = 1e-6;

  double along(Point p) const { return steep_ ? p.y : p.x; }
  double across(Point p) const { return steep_ ? p.x : p.y; }
  std::int32_t count() const { return steep_ ? scene_.bins().rows() : scene_.bins().columns(); }
  std::int32_t column_at(double t) const {
    const BinIndex bin = scene_.bins().clamped(origin_ + t * direction_);
    return steep_ ? bin.row : bin.column;
  }
  std::int32_t row_at(double t, double aside) const {
    const Point p = origin_ + t * direction_ + (steep_ ? Point{aside, 0.0} : Point{0.0, aside});
    const BinIndex bin = scene_.bins().clamped(p);
    return steep_ ? bin.column : bin.row;
  }
  // Distance along the ray to the line between columns i − 1 and i.
  double time_at(std::int32_t i) const {
    const double line = along(scene_.bins().corner()) + i * scene_.bins().bin_size_m();
    return (line - along(origin_)) / along(direction_);
  }

  void visit_column(std::int32_t i, double enter, double leave) {
    const double slack = kSlack * scene_.bins().bin_size_m();
    const auto [low, high] = std::minmax(
        {row_at(enter, -slack), row_at(enter, slack), row_at(leave, -slack), row_at(leave, slack)});
    for (std::int32_t j = low; j <= high; ++j) {
      const BinIndex bin = steep_ ? BinIndex{j, i} : BinIndex{i, j};
      for (const std::uint32_t item : scene_.bins().items(bin)) meet(item);
    }
  }

  void meet(std::uint32_t item) {
    if (scene_.is_ramp(item)) {
      for (const OneSidedSegment& line : iso_lines(scene_.ramp(item), height_m_)) {
        shorten(distance_to_one_sided(direction_, line.a - origin_, line.b - origin_));
      }
      return;
    }
    const std::uint32_t obstacle = scene_.obstacle_of(item);
    if (scene_.obstacles()[obstacle].stairs) {
      meet_stairs(obstacle);
    } else if (scene_.segments()[item].height_m > height_m_) {
      shorten(distance_to(scene_.segments()[item]));
    }
  }

  void meet_stairs(std::uint32_t obstacle) {
    if (std::find(stairs_met_.begin(), stairs_met_.end(), obstacle) != stairs_met_.end()) return;
    stairs_met_.push_back(obstacle);
    double top = kNever, step = kNever, stop = kNever;
    for (const SceneSegment& segment : scene_.segments_of(scene_.obstacles()[obstacle])) {
      const double t = distance_to(segment);
      double& first = segment.height_m > 0.0 ? step : top;
      first = std::min(first, t);
      if (segment.height_m > height_m_) stop = std::min(stop, t);
    }
    if (step <= top) shorten(stop);
  }

  double distance_to(const SceneSegment& segment) const {
    return distance_to_segment(direction_, segment.a - origin_, segment.b - origin_);
  }
  void shorten(double range_m) { range_m_ = std::min(range_m_, range_m); }

  const Scene& scene_;
  const Point origin_;
  const Point direction_;
  const double height_m_;
  double range_m_;
  bool steep_ = false;
  std::vector<std::uint32_t> stairs_met_;
};

}  // namespace

double cast_ray(const Scene& scene, Point origin, Point direction, double height_m,
                double max_range_m) {
  return SingleRay(scene, origin, direction, height_m, max_range_m).cast();
}

}  // namespace mapwright::navcore::engine
