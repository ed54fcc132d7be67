#include "converter/pipeline/map_transform.hpp"

#include <array>

namespace mapwright::converter {

void MapTransform::apply(std::span<double> xs, std::span<double> ys) const {
  if (!to_wgs84_) return;
  to_wgs84_->to_wgs84(xs, ys);
  frame_->to_map(xs, ys);
}

Point MapTransform::grid_north(double x, double y) const {
  constexpr double kReach_m = 10.0;
  std::array<double, 2> xs{x, x};
  std::array<double, 2> ys{y, y + kReach_m / metres_per_unit_};
  apply(xs, ys);
  const Point north{xs[1] - xs[0], ys[1] - ys[0]};
  const double reach = length(north);
  return reach > 0.0 ? (1.0 / reach) * north : Point{0.0, 1.0};
}

}  // namespace mapwright::converter
