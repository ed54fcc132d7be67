// Polygons of public validity suites, with the verdict of each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mapwright::test {

struct SuiteCase {
  std::string name;
  std::string wkt;  ///< POLYGON or MULTIPOLYGON
  bool valid = true;
};

/// Cases of an XML file of JTS and GEOS that ask for isValid.
std::vector<SuiteCase> geos_validity_cases(const std::filesystem::path& xml);

/// Polygons of PostGIS's isvaliddetail test, with the verdict its expected answers give.
std::vector<SuiteCase> postgis_validity_cases(const std::filesystem::path& folder);

/// Faces of val3dity's polyhedra (.poly), laid on the plane of two axes in which they are largest,
/// beside each other. The verdict is GEOS's.
std::vector<SuiteCase> val3dity_faces(const std::filesystem::path& folder);

/// True for a geometry that GEOS calls valid.
bool is_valid_by_geos(const std::string& wkt);

}  // namespace mapwright::test
