// Whether the two descriptions of a map frame in its sidecar are of one frame.
#pragma once

#include <optional>

#include "mapcore/finding.hpp"
#include "mapcore/georeference.hpp"

namespace mapwright::converter {

/// C241 where the sidecar's wkt2 takes points within 1 km of the origin elsewhere than origin,
/// heading and projection do (by more than tolerance::kFrameAgreement_m), or PROJ cannot use it.
/// Nothing where they agree or wkt2 is empty.
std::optional<Finding> frame_mismatch(const Georeference& georeference);

}  // namespace mapwright::converter
