#include "converter/pipeline/map_transform.hpp"

#include <array>

namespace mapwright::converter {
namespace {

// Sides of the cells of TransformPatches: about 7 km, in numbers that are exact in binary.
constexpr double kCell = 8192.0;
constexpr double kCell_deg = 0.0625;

}  // namespace

void MapTransform::Route::apply(std::span<double> xs, std::span<double> ys) const {
  to_wgs84.to_wgs84(xs, ys);
  frame->to_map(xs, ys);
}

MapTransform::MapTransform(CrsTransform to_wgs84, const LocalFrame& frame, const Crs& crs)
    : route_(std::make_shared<Route>(Route{std::move(to_wgs84), &frame})),
      patches_(std::make_shared<TransformPatches>(
          [route = route_](std::span<double> xs, std::span<double> ys) { route->apply(xs, ys); },
          crs.geographic ? kCell_deg : kCell)),
      metres_per_unit_(crs.metres_per_unit) {}

void MapTransform::apply(std::span<double> xs, std::span<double> ys) {
  if (patches_) return patches_->apply(xs, ys);
  if (local_unit_m_ == 1.0) return;
  for (double& x : xs) x *= local_unit_m_;
  for (double& y : ys) y *= local_unit_m_;
}

bool MapTransform::apply_nearby(std::span<double> xs, std::span<double> ys, double reach) const {
  return patches_ && patches_->apply_in_last_cell(xs, ys, reach);
}

void MapTransform::apply_exactly(std::span<double> xs, std::span<double> ys) const {
  if (route_) route_->apply(xs, ys);
}

Point MapTransform::grid_north(double x, double y) const {
  constexpr double kReach_m = 10.0;
  std::array<double, 2> xs{x, x};
  std::array<double, 2> ys{y, y + kReach_m / metres_per_unit_};
  apply_exactly(xs, ys);
  const Point north{xs[1] - xs[0], ys[1] - ys[0]};
  const double reach = length(north);
  return reach > 0.0 ? (1.0 / reach) * north : Point{0.0, 1.0};
}

}  // namespace mapwright::converter
