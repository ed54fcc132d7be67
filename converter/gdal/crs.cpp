#include "converter/gdal/crs.hpp"

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>

#include "converter/gdal/crs_of.hpp"
#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

constexpr double kMetresPerRadian = 6378137.0;

std::string wkt2_of(const OGRSpatialReference& reference) {
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  reference.exportToWkt(&text, options);
  std::string wkt = text == nullptr ? "" : text;
  CPLFree(text);
  return wkt;
}

std::string code_of(const OGRSpatialReference& reference) {
  const char* authority = reference.GetAuthorityName(nullptr);
  const char* code = reference.GetAuthorityCode(nullptr);
  if (authority == nullptr || code == nullptr) return {};
  return std::string(authority) + ":" + code;
}

bool says_nothing(const OGRSpatialReference& reference) {
  const char* name = reference.GetName();
  return reference.IsEmpty() || reference.IsLocal() ||
         (name != nullptr && std::string(name).rfind("Undefined ", 0) == 0);
}

OGRSpatialReference wgs84() {
  OGRSpatialReference reference;
  reference.SetWellKnownGeogCS("WGS84");
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

// As the registry has it where that is the same in every respect: GDAL asks both for their text as
// of 2001, and of what was read from a text PROJ searches its whole database for datums' names
// then.
OGRSpatialReference source_of(const Crs& crs) {
  OGRSpatialReference stated, registered;
  stated.importFromWkt(crs.wkt.c_str());
  const char* const strictly[] = {"CRITERION=STRICT", nullptr};
  const bool is_registered = crs.code.starts_with("EPSG:") &&
                             registered.SetFromUserInput(crs.code.c_str()) == OGRERR_NONE &&
                             registered.IsSame(&stated, strictly) != 0;
  auto& source = is_registered ? registered : stated;
  source.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return source;
}

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

void transform(OGRCoordinateTransformation* transformation, std::span<double> xs,
               std::span<double> ys) {
  if (transformation == nullptr || xs.empty()) return;
  const GdalMessages quiet;
  transformation->Transform(static_cast<int>(xs.size()), xs.data(), ys.data(), nullptr, nullptr);
  for (std::size_t i = 0; i < xs.size(); ++i) {  // points that failed are infinite
    if (std::isfinite(xs[i]) && std::isfinite(ys[i])) continue;
    xs[i] = ys[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

Crs crs_of(const OGRSpatialReference* reference) {
  if (reference == nullptr || says_nothing(*reference)) return {};
  Crs crs;
  crs.code = code_of(*reference);
  crs.name = reference->GetName() == nullptr ? "" : reference->GetName();
  crs.wkt = wkt2_of(*reference);
  crs.geographic = reference->IsGeographic() != 0;
  crs.metres_per_unit = crs.geographic ? kMetresPerRadian * reference->GetAngularUnits()
                                       : reference->GetLinearUnits();
  return crs;
}

std::optional<GeoBox> area_of_use(const Crs& crs) {
  const GdalMessages messages;
  OGRSpatialReference reference;
  GeoBox box;
  if (reference.SetFromUserInput(crs.definition().c_str()) != OGRERR_NONE ||
      !reference.GetAreaOfUse(&box.west_deg, &box.south_deg, &box.east_deg, &box.north_deg,
                              nullptr)) {
    return std::nullopt;
  }
  return box;
}

std::optional<std::pair<double, double>> longitude_latitude_on_own_datum(const Crs& crs, double x,
                                                                         double y) {
  const GdalMessages messages;
  OGRSpatialReference reference;
  if (reference.importFromWkt(crs.wkt.c_str()) != OGRERR_NONE) return std::nullopt;
  const std::unique_ptr<OGRSpatialReference> base(reference.CloneGeogCS());
  if (!base || !reference.IsProjected()) return std::nullopt;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  base->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const Transformation transformation(OGRCreateCoordinateTransformation(&reference, base.get()));
  if (!transformation || !transformation->Transform(1, &x, &y)) return std::nullopt;
  return std::pair(x, y);
}

Result<Crs> parse_crs(const std::string& definition) {
  const GdalMessages messages;
  OGRSpatialReference reference;
  const auto error = reference.SetFromUserInput(
      definition.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get());
  if (error != OGRERR_NONE || reference.IsEmpty()) {
    return usage_failure("'" + definition +
                         "' is no coordinate reference system: give EPSG:CODE or WKT");
  }
  Crs crs = crs_of(&reference);
  if (!crs.is_stated()) {
    return usage_failure("'" + definition +
                         "' has no place on Earth: use --local for plain metres");
  }
  return crs;
}

struct CrsTransform::Impl {
  Transformation forward;  // null: the CRS is WGS 84 itself
  Transformation backward;
};

CrsTransform::CrsTransform(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
CrsTransform::CrsTransform(CrsTransform&&) noexcept = default;
CrsTransform& CrsTransform::operator=(CrsTransform&&) noexcept = default;
CrsTransform::~CrsTransform() = default;

Result<CrsTransform> CrsTransform::create(const Crs& crs, Ways ways) {
  const GdalMessages messages;
  auto impl = std::make_unique<Impl>();
  if (crs.code == "EPSG:4326" || crs.code == "OGC:CRS84") return CrsTransform(std::move(impl));
  const auto source = source_of(crs);
  const auto target = wgs84();
  impl->forward.reset(OGRCreateCoordinateTransformation(&source, &target));
  const bool both = ways == Ways::kBoth;
  if (both) impl->backward.reset(OGRCreateCoordinateTransformation(&target, &source));
  if (!impl->forward || (both && !impl->backward)) {
    return input_failure("no way is known from " + crs.title() +
                         " to WGS 84: " + messages.first_error());
  }
  return CrsTransform(std::move(impl));
}

void CrsTransform::to_wgs84(std::span<double> xs, std::span<double> ys) const {
  transform(impl_->forward.get(), xs, ys);
}

void CrsTransform::from_wgs84(std::span<double> longitudes, std::span<double> latitudes) const {
  transform(impl_->backward.get(), longitudes, latitudes);
}

}  // namespace mapwright::converter
