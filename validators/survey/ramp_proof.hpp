// Private to this folder: Proof, at one look, that no check of ramps has anything to say.
#pragma once

#include "mapcore/map.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// True only if the ramp, whose chain is joined, has a unit normal within all limits and a
/// footprint of height 0: every check T201 to T130 is silent then.
bool is_plain_ramp(const Obstacle& ramp, const ValidationOptions& options);

}  // namespace mapwright::validators
