// Private to this folder: the elements of a KML document that GDAL makes nothing, or too much, of.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace mapwright::converter {

/// What GDAL makes a feature of.
enum class KmlFeature { kPlain, kModel, kPicture };

/// A folder or document within a KML document, without those it holds in turn.
struct KmlContainer {
  std::string name;                  ///< empty if it has none
  std::vector<KmlFeature> features;  ///< in order
  std::vector<std::string> links;    ///< addresses that its network links lead to
};

struct KmlElements {
  std::vector<KmlContainer> containers;            ///< in the order in which they begin
  std::map<std::string, std::size_t> passed_over;  ///< kinds of pictures that GDAL passes over
};

KmlElements kml_elements(const std::string& path);

}  // namespace mapwright::converter
