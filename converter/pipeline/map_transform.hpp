// From a layer's coordinates to the map frame.
#pragma once

#include <optional>
#include <span>

#include "converter/frame/local_frame.hpp"
#include "converter/gdal/crs.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

class MapTransform {
 public:
  /// Plain local metres: coordinates stay as they are.
  MapTransform() = default;
  /// Source CRS → WGS 84 → map frame. Borrows the frame.
  MapTransform(CrsTransform to_wgs84, const LocalFrame& frame, double metres_per_unit)
      : to_wgs84_(std::move(to_wgs84)), frame_(&frame), metres_per_unit_(metres_per_unit) {}

  /// Source coordinates to metres of the map frame, in place; NaN where there is no way.
  void apply(std::span<double> xs, std::span<double> ys) const;

  /// North of the source's grid at a place given in source coordinates: unit vector, map frame.
  Point grid_north(double x, double y) const;

 private:
  std::optional<CrsTransform> to_wgs84_;
  const LocalFrame* frame_ = nullptr;
  double metres_per_unit_ = 1.0;
};

}  // namespace mapwright::converter
