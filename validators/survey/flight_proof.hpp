// Private to this folder: Proof, at one look, that no check of stairs has anything to say.
#pragma once

#include <span>

#include "mapcore/map.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// True only if the segments of stairs, each of which has a length, are a flight as the report's
/// prose describes it: from the foot up, each step one segment, of even rise and tread within all
/// limits, and the closing segment behind them. Every check T101 to T126 is silent then.
bool is_plain_flight(std::span<const Segment> segments, const ValidationOptions& options);

}  // namespace mapwright::validators
