#include "validators/georeference_checks.hpp"

#include <algorithm>
#include <string>

#include "mapcore/defect_geometry.hpp"
#include "mapcore/tolerances.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Maps drawn by hand in local metres need no sidecar; those made of GIS features had one.
void check_missing(const Map& map, std::vector<Finding>& findings) {
  const auto made = std::find_if(map.obstacles.begin(), map.obstacles.end(), [](const Obstacle& o) {
    return o.semantic.value(semantic_key::kSource).has_value();
  });
  if (made == map.obstacles.end()) return;
  findings.push_back(
      make_finding(FindingCode::C240,
                   name_of(*made) + " comes from the GIS feature '" +
                       std::string(*made->semantic.value(semantic_key::kSource)) +
                       "', but there is no georeference sidecar beside the map; copy it there, "
                       "or convert again"));
}

void check_distance(const Map& map, std::vector<Finding>& findings) {
  const Border& border = map.border;
  const Point nearest{
      std::clamp(0.0, std::min(border.left, border.right), std::max(border.left, border.right)),
      std::clamp(0.0, std::min(border.bottom, border.top), std::max(border.bottom, border.top))};
  const double away_m = length(nearest);
  if (!(away_m > tolerance::kFarFromOrigin_m)) return;
  findings.push_back(
      make_finding(FindingCode::C242,
                   "the border lies " + metres(away_m / 1000.0) +
                       " km from the origin of the georeference, where the plane is no longer "
                       "true to scale; choose an origin on the site"));
  findings.back().at = nearest;
  findings.back().geometry = geometry_of(border);
}

void check_origin(const Georeference& georeference, std::vector<Finding>& findings) {
  if (georeference.origin_latitude_deg != 0.0 || georeference.origin_longitude_deg != 0.0) return;
  findings.push_back(
      make_finding(FindingCode::C243,
                   "the origin of the georeference is latitude 0, longitude 0, in the Gulf of "
                   "Guinea; set it, or remove the sidecar"));
}

}  // namespace

std::vector<Finding> check_georeference(const Map& map,
                                        const std::optional<Georeference>& georeference) {
  std::vector<Finding> findings;
  if (!georeference) {
    check_missing(map, findings);
    return findings;
  }
  check_distance(map, findings);
  check_origin(*georeference, findings);
  return findings;
}

}  // namespace mapwright::validators
