#include "converter/exporters/gis/placement.hpp"

#include <cmath>
#include <cstdio>

#include "converter/frame/local_frame.hpp"

namespace mapwright::converter {
namespace {

constexpr int kRounds = 4;
constexpr double kShareOfResolution = 0.1;

class Placement {
 public:
  Placement(const Georeference& georeference, const CrsTransform& crs)
      : frame_(georeference), crs_(crs) {}

  /// Points of the map frame to the CRS, in place; returns the greatest distance in metres that a
  /// point comes back off, and which point that is.
  struct Worst {
    double off_m = 0.0;
    Point at;
  };
  Worst place(std::vector<double>& xs, std::vector<double>& ys, double tolerance_m) const {
    const std::vector<double> wanted_x = xs, wanted_y = ys;
    std::vector<double> aim_x = xs, aim_y = ys;
    Worst worst;
    for (int round = 0; round < kRounds; ++round) {
      xs = aim_x;
      ys = aim_y;
      to_crs(xs, ys);
      std::vector<double> back_x = xs, back_y = ys;
      to_map(back_x, back_y);
      worst = {};
      for (std::size_t i = 0; i < xs.size(); ++i) {
        const Point off{wanted_x[i] - back_x[i], wanted_y[i] - back_y[i]};
        const double off_m = is_finite(off) ? length(off) : HUGE_VAL;
        if (off_m > worst.off_m) worst = {off_m, {wanted_x[i], wanted_y[i]}};
        if (!is_finite(off)) continue;
        aim_x[i] += off.x;
        aim_y[i] += off.y;
      }
      if (worst.off_m <= tolerance_m || !std::isfinite(worst.off_m)) break;
    }
    return worst;
  }

 private:
  void to_crs(std::vector<double>& xs, std::vector<double>& ys) const {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const GeoPoint place = frame_.to_wgs84(Point{xs[i], ys[i]});
      xs[i] = place.longitude_deg;
      ys[i] = place.latitude_deg;
    }
    crs_.from_wgs84(xs, ys);
  }
  void to_map(std::vector<double>& xs, std::vector<double>& ys) const {
    crs_.to_wgs84(xs, ys);
    frame_.to_map(xs, ys);
  }

  LocalFrame frame_;
  const CrsTransform& crs_;
};

Failure out_of_reach(const Placement::Worst& worst, const Crs& crs) {
  char text[200];
  if (std::isfinite(worst.off_m)) {
    std::snprintf(text, sizeof text,
                  "(%.10g, %.10g) would come back %.2g m off, too far for the map's resolution",
                  worst.at.x, worst.at.y, worst.off_m);
  } else {
    std::snprintf(text, sizeof text, "(%.10g, %.10g) has no place there", worst.at.x, worst.at.y);
  }
  return {FailureKind::kUsage,
          crs.title() + " cannot hold the map: " + text +
              "; choose another --crs, or --crs map for metres of the map frame"};
}

}  // namespace

Result<void> place(std::vector<GisLayer>& layers, const Georeference& georeference, const Crs& crs,
                   double resolution_m) {
  const auto transform = CrsTransform::create(crs);
  if (!transform) return tl::unexpected(transform.error());
  const Placement placement(georeference, *transform);
  const double tolerance_m = kShareOfResolution * resolution_m;
  for (auto& layer : layers) {
    std::vector<double> xs, ys;
    for (const auto& feature : layer.features) {
      for (const auto& path : feature.paths) {
        for (const Point p : path) {
          xs.push_back(p.x);
          ys.push_back(p.y);
        }
      }
    }
    const auto worst = placement.place(xs, ys, tolerance_m);
    if (worst.off_m > tolerance_m) return tl::unexpected(out_of_reach(worst, crs));
    std::size_t next = 0;
    for (auto& feature : layer.features) {
      for (auto& path : feature.paths) {
        for (Point& p : path) {
          p = {xs[next], ys[next]};
          ++next;
        }
      }
    }
  }
  return {};
}

}  // namespace mapwright::converter
