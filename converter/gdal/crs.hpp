// Coordinate reference systems, and the way from them to WGS 84 (PROJ, by way of GDAL).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// What is known of a CRS. A default-constructed one is none at all.
struct Crs {
  std::string code;  ///< "EPSG:25831"; empty where the CRS has no code
  std::string name;  ///< "ETRS89 / UTM zone 31N"
  std::string wkt;   ///< WKT2; empty: no CRS
  bool geographic = false;
  double metres_per_unit = 1.0;  ///< of a degree along the meridian for a geographic CRS

  bool is_stated() const { return !wkt.empty(); }
  /// The code, else the name.
  const std::string& title() const { return code.empty() ? name : code; }
  /// What a sidecar keeps: the code, else the WKT.
  const std::string& definition() const { return code.empty() ? wkt : code; }

  friend bool operator==(const Crs&, const Crs&) = default;
};

/// A piece of the Earth between two meridians and two parallels. Where west > east it holds the
/// antimeridian.
struct GeoBox {
  double west_deg = 0.0, south_deg = 0.0, east_deg = 0.0, north_deg = 0.0;
};

/// Where a CRS is meant to be used, by PROJ's database; nothing for one it does not know.
std::optional<GeoBox> area_of_use(const Crs& crs);

/// A place in degrees on the CRS's own datum: no shift of datums, which may be 100 m and costs much
/// to find out. Nothing where the CRS is not projected or does not reach there.
std::optional<std::pair<double, double>> longitude_latitude_on_own_datum(const Crs& crs, double x,
                                                                         double y);

/// Reads "EPSG:25831", WKT, PROJJSON or a PROJ string. Fails (kUsage) for anything else; opens no
/// file and no connection.
Result<Crs> parse_crs(const std::string& definition);

/// Between a CRS and WGS 84. Coordinates are x = easting or longitude, y = northing or latitude,
/// whatever order the CRS's authority writes them in; angles in degrees.
class CrsTransform {
 public:
  /// Finding a way among those that PROJ knows takes milliseconds, each way anew.
  enum class Ways { kBoth, kToWgs84 };

  /// Fails (kInput) where PROJ knows no way. `from_wgs84` needs both.
  static Result<CrsTransform> create(const Crs& crs, Ways ways = Ways::kBoth);
  CrsTransform(CrsTransform&&) noexcept;
  CrsTransform& operator=(CrsTransform&&) noexcept;
  ~CrsTransform();

  /// From the CRS to longitude and latitude, in place. What cannot be transformed becomes NaN.
  void to_wgs84(std::span<double> xs, std::span<double> ys) const;

  /// The way back.
  void from_wgs84(std::span<double> longitudes, std::span<double> latitudes) const;

 private:
  struct Impl;
  explicit CrsTransform(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
