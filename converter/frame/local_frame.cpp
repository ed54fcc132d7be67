#include "converter/frame/local_frame.hpp"

#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/TransverseMercator.hpp>

#include "mapcore/angle.hpp"

namespace mapwright::converter {

struct LocalFrame::Projection {
  virtual ~Projection() = default;
  virtual Point forward(GeoPoint place) const = 0;  // east, north of the origin
  virtual GeoPoint reverse(Point east_north) const = 0;
};

class LocalFrame::TransverseMercatorProjection final : public Projection {
 public:
  explicit TransverseMercatorProjection(const Georeference& g)
      : central_longitude_deg_(g.origin_longitude_deg),
        projection_(GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1.0) {
    double easting = 0.0;
    projection_.Forward(central_longitude_deg_, g.origin_latitude_deg, central_longitude_deg_,
                        easting, origin_northing_m_);
  }
  Point forward(GeoPoint place) const override {
    Point p;
    projection_.Forward(central_longitude_deg_, place.latitude_deg, place.longitude_deg, p.x, p.y);
    return {p.x, p.y - origin_northing_m_};
  }
  GeoPoint reverse(Point p) const override {
    GeoPoint place;
    projection_.Reverse(central_longitude_deg_, p.x, p.y + origin_northing_m_, place.latitude_deg,
                        place.longitude_deg);
    return place;
  }

 private:
  double central_longitude_deg_;
  double origin_northing_m_ = 0.0;
  GeographicLib::TransverseMercator projection_;
};

class LocalFrame::TangentPlaneProjection final : public Projection {
 public:
  explicit TangentPlaneProjection(const Georeference& g)
      : height_m_(g.origin_height_m),
        plane_(g.origin_latitude_deg, g.origin_longitude_deg, g.origin_height_m) {}
  Point forward(GeoPoint place) const override {
    Point p;
    double up = 0.0;
    plane_.Forward(place.latitude_deg, place.longitude_deg, height_m_, p.x, p.y, up);
    return p;
  }
  // The height above the plane that belongs to the origin's ellipsoidal height: each round divides
  // the error by the radius of the Earth over the distance.
  GeoPoint reverse(Point p) const override {
    GeoPoint place;
    double up = 0.0;
    for (int round = 0; round < 6; ++round) {
      double height = 0.0;
      plane_.Reverse(p.x, p.y, up, place.latitude_deg, place.longitude_deg, height);
      up -= height - height_m_;
    }
    return place;
  }

 private:
  double height_m_;
  GeographicLib::LocalCartesian plane_;
};

LocalFrame::LocalFrame(const Georeference& georeference)
    : north_(unit_vector_deg(90.0 + georeference.heading_deg)) {
  if (georeference.projection == FrameProjection::kTransverseMercator) {
    projection_ = std::make_unique<TransverseMercatorProjection>(georeference);
  } else {
    projection_ = std::make_unique<TangentPlaneProjection>(georeference);
  }
}

LocalFrame::LocalFrame(LocalFrame&&) noexcept = default;
LocalFrame& LocalFrame::operator=(LocalFrame&&) noexcept = default;
LocalFrame::~LocalFrame() = default;

// With north as the map sees it, east is its right hand.
Point LocalFrame::to_map(GeoPoint place) const {
  const Point p = projection_->forward(place);
  return {p.x * north_.y + p.y * north_.x, p.y * north_.y - p.x * north_.x};
}

GeoPoint LocalFrame::to_wgs84(Point p) const {
  return projection_->reverse({p.x * north_.y - p.y * north_.x, p.x * north_.x + p.y * north_.y});
}

void LocalFrame::to_map(std::span<double> xs, std::span<double> ys) const {
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const Point p = to_map(GeoPoint{xs[i], ys[i]});
    xs[i] = p.x;
    ys[i] = p.y;
  }
}

}  // namespace mapwright::converter
