// The map frame: metres around an origin, turned by a heading.
#pragma once

#include <memory>
#include <span>

#include "mapcore/georeference.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

struct GeoPoint {
  double longitude_deg = 0.0;
  double latitude_deg = 0.0;
};

/// Between WGS 84 and the map frame of a georeference (GeographicLib).
///
/// tmerc: transverse Mercator centred on the origin with scale 1 there (Karney 2011, error below
/// 10 nm within 3,000 km). enu: local tangent plane at the origin; every point is taken at the
/// origin's ellipsoidal height. Immutable; safe to use from many threads.
class LocalFrame {
 public:
  explicit LocalFrame(const Georeference& georeference);
  LocalFrame(LocalFrame&&) noexcept;
  LocalFrame& operator=(LocalFrame&&) noexcept;
  ~LocalFrame();

  /// Metres, map frame. NaN in gives NaN out.
  Point to_map(GeoPoint place) const;
  GeoPoint to_wgs84(Point p) const;

  /// Longitudes and latitudes (degrees) to x and y (metres), in place.
  void to_map(std::span<double> xs, std::span<double> ys) const;

 private:
  struct Projection;
  class TransverseMercatorProjection;
  class TangentPlaneProjection;
  std::unique_ptr<const Projection> projection_;
  Point north_;  ///< true north at the origin, as a unit vector of the map frame
};

}  // namespace mapwright::converter
