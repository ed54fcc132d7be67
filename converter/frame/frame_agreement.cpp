#include "converter/frame/frame_agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

#include "converter/frame/local_frame.hpp"
#include "converter/gdal/crs.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {
namespace {

constexpr double kReach_m = 1000.0;
constexpr std::array<Point, 4> kProbes{
    {{0.0, 0.0}, {kReach_m, 0.0}, {0.0, kReach_m}, {-kReach_m, -kReach_m}}};

// Greatest distance between the probes and where the frame finds the places the WKT gives them;
// not a number where the WKT does not reach there.
double disagreement_m(const LocalFrame& frame, const CrsTransform& wkt) {
  std::array<double, kProbes.size()> xs{}, ys{};
  for (std::size_t i = 0; i < kProbes.size(); ++i) {
    xs[i] = kProbes[i].x;
    ys[i] = kProbes[i].y;
  }
  wkt.to_wgs84(xs, ys);
  double greatest_m = 0.0;
  for (std::size_t i = 0; i < kProbes.size(); ++i) {
    const double apart_m = distance(frame.to_map({xs[i], ys[i]}), kProbes[i]);
    if (std::isnan(apart_m)) return apart_m;
    greatest_m = std::max(greatest_m, apart_m);
  }
  return greatest_m;
}

Finding mismatch(const std::string& what) {
  return make_finding(FindingCode::C241,
                      "the georeference's \"wkt2\" " + what +
                          "; empty it, or convert again: robots go by origin and heading");
}

std::string with_centimetres(double metres) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << metres;
  return out.str();
}

}  // namespace

std::optional<Finding> frame_mismatch(const Georeference& georeference) {
  if (georeference.wkt2.empty()) return std::nullopt;
  const auto crs = parse_crs(georeference.wkt2);
  if (!crs) return mismatch("is no coordinate reference system that PROJ can use");
  const auto transform = CrsTransform::create(*crs);
  if (!transform) return mismatch("cannot be used: " + transform.error().message);
  const double apart_m = disagreement_m(LocalFrame(georeference), *transform);
  if (apart_m <= tolerance::kFrameAgreement_m) return std::nullopt;
  if (std::isnan(apart_m)) return mismatch("does not reach the origin");
  return mismatch(
      "describes another frame than origin, heading and projection: within 1 km they "
      "are up to " +
      with_centimetres(apart_m) + " m apart");
}

}  // namespace mapwright::converter
