// Private to this folder: A finding as JSON from which it can be made again.
#pragma once

#include <nlohmann/json.hpp>

#include "mapcore/finding.hpp"

namespace mapwright::validators {

/// The object of `finding_json`, with what it cannot say put beside it.
nlohmann::ordered_json finding_record_json(const Finding& finding);

/// The same finding, but for coordinates that are no finite numbers. Throws an exception derived
/// from std::exception for what is no finding, or one that this version does not know.
Finding parse_finding_record(const nlohmann::ordered_json& json);

}  // namespace mapwright::validators
