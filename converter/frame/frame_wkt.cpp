#include "converter/frame/frame_wkt.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>

#include "mapcore/angle.hpp"

namespace mapwright::converter {
namespace {

constexpr double kEquatorialRadius_m = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;

std::string number(double value) {
  char buffer[40];
  const auto result =
      std::to_chars(std::begin(buffer), std::end(buffer), value == 0.0 ? 0.0 : value);
  return {std::begin(buffer), result.ptr};
}

constexpr std::string_view kDegree = R"(ANGLEUNIT["degree",0.0174532925199433])";
constexpr std::string_view kMetre = R"(LENGTHUNIT["metre",1])";

std::string parameter(std::string_view name, double value, std::string_view unit, int epsg) {
  return R"(,PARAMETER[")" + std::string(name) + "\"," + number(value) + "," + std::string(unit) +
         R"(,ID["EPSG",)" + std::to_string(epsg) + "]]";
}

std::string method(std::string_view name, int epsg) {
  return R"(METHOD[")" + std::string(name) + R"(",ID["EPSG",)" + std::to_string(epsg) + "]]";
}

std::string geographic_base() {
  return R"(BASEGEOGCRS["WGS 84",DATUM["World Geodetic System 1984",)"
         R"(ELLIPSOID["WGS 84",6378137,298.257223563,LENGTHUNIT["metre",1]]],)"
         R"(PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]],ID["EPSG",4326]])";
}

std::string projection(const Georeference& g) {
  const bool tmerc = g.projection == FrameProjection::kTransverseMercator;
  std::string text = R"(CONVERSION["about the map's origin",)";
  text += tmerc ? method("Transverse Mercator", 9807) : method("Orthographic", 9840);
  text += parameter("Latitude of natural origin", g.origin_latitude_deg, kDegree, 8801);
  text += parameter("Longitude of natural origin", g.origin_longitude_deg, kDegree, 8802);
  if (tmerc) {
    text += parameter("Scale factor at natural origin", 1.0, R"(SCALEUNIT["unity",1])", 8805);
  }
  text += parameter("False easting", 0.0, kMetre, 8806);
  text += parameter("False northing", 0.0, kMetre, 8807);
  return text + "]";
}

std::string axis(std::string_view name, std::string_view direction, int order) {
  return ",AXIS[\"(" + std::string(name) + ")\"," + std::string(direction) + ",ORDER[" +
         std::to_string(order) + "]]";
}

std::string axes(std::string_view x, std::string_view y) {
  return ",CS[Cartesian,2]" + axis(x, "east", 1) + axis(y, "north", 2) + "," + std::string(kMetre) +
         "]";
}

// At height h lengths along the parallel grow by 1 + h/ν, along the meridian by 1 + h/ρ.
Point stretch(const Georeference& g) {
  if (g.projection == FrameProjection::kTransverseMercator) return {1.0, 1.0};
  const double e2 = kFlattening * (2.0 - kFlattening);
  const double s = std::sin(g.origin_latitude_deg * (std::numbers::pi / 180.0));
  const double nu = kEquatorialRadius_m / std::sqrt(1.0 - e2 * s * s);
  const double rho = nu * (1.0 - e2) / (1.0 - e2 * s * s);
  return {1.0 + g.origin_height_m / nu, 1.0 + g.origin_height_m / rho};
}

std::string turn(const Georeference& g) {
  const Point north = unit_vector_deg(90.0 + g.heading_deg);
  const Point scale = stretch(g);
  constexpr std::string_view kUnity = R"(SCALEUNIT["coefficient",1])";
  return R"(,DERIVINGCONVERSION["to the map's axes",)" +
         method("Affine parametric transformation", 9624) + parameter("A0", 0.0, kMetre, 8623) +
         parameter("A1", north.y * scale.x, kUnity, 8624) +
         parameter("A2", north.x * scale.y, kUnity, 8625) + parameter("B0", 0.0, kMetre, 8639) +
         parameter("B1", -north.x * scale.x, kUnity, 8640) +
         parameter("B2", north.y * scale.y, kUnity, 8641) + "]";
}

}  // namespace

std::string frame_wkt2(const Georeference& g) {
  const Point scale = stretch(g);
  if (g.heading_deg == 0.0 && scale == Point{1.0, 1.0}) {
    return R"(PROJCRS["mapwright map frame",)" + geographic_base() + "," + projection(g) +
           axes("E", "N");
  }
  return R"(DERIVEDPROJCRS["mapwright map frame",BASEPROJCRS["east and north of the map's origin",)" +
         geographic_base() + "," + projection(g) + "]" + turn(g) + axes("x", "y");
}

}  // namespace mapwright::converter
