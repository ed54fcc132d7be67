// Private to this folder: attribute values of OGR features.
#pragma once

#include <vector>

#include "converter/source/feature.hpp"

class OGRFeature;

namespace mapwright::converter {

/// Fills in `feature.values` (as many as the layer has fields). Texts that are not UTF-8 are read
/// as ISO-8859-1 and named in `feature.reencoded`.
void read_values(const OGRFeature& from, SourceFeature& feature);

}  // namespace mapwright::converter
