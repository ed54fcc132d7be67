// From a layer's coordinates to the map frame.
#pragma once

#include <memory>
#include <span>

#include "converter/frame/local_frame.hpp"
#include "converter/frame/transform_patches.hpp"
#include "converter/gdal/crs.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

class MapTransform {
 public:
  /// Plain local metres: coordinates stay as they are.
  MapTransform() = default;
  /// Local coordinates in another unit.
  explicit MapTransform(double metres_per_unit) : local_unit_m_(metres_per_unit) {}
  /// Source CRS → WGS 84 → map frame. Borrows the frame.
  MapTransform(CrsTransform to_wgs84, const LocalFrame& frame, const Crs& crs);

  /// Source coordinates to metres of the map frame, in place; NaN where there is no way. Within
  /// TransformPatches::kBound_m of apply_exactly.
  void apply(std::span<double> xs, std::span<double> ys);

  /// The same for points near those before, whose images are sure to lie no farther than `reach`
  /// from either axis: numbers that need no look before or after. Else false, and nothing is done.
  bool apply_nearby(std::span<double> xs, std::span<double> ys, double reach) const;

  /// The same by PROJ and GeographicLib, point by point.
  void apply_exactly(std::span<double> xs, std::span<double> ys) const;

  /// North of the source's grid at a place given in source coordinates: unit vector, map frame.
  Point grid_north(double x, double y) const;

 private:
  struct Route {
    CrsTransform to_wgs84;
    const LocalFrame* frame;
    void apply(std::span<double> xs, std::span<double> ys) const;
  };

  std::shared_ptr<const Route> route_;  // none: plain local metres
  std::shared_ptr<TransformPatches> patches_;
  double local_unit_m_ = 1.0;     // where there is no route
  double metres_per_unit_ = 1.0;  // of the source's CRS
};

}  // namespace mapwright::converter
