// Private to this folder: A finding as JSON from which it can be made again.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "mapcore/finding.hpp"
#include "validators/fingerprint.hpp"

namespace mapwright::validators {

/// The object of `finding_json`, with what it cannot say put beside it. `name` may be null.
nlohmann::ordered_json finding_record_json(const Finding& finding, const Fingerprint* name);

/// The same finding, but for coordinates that are no finite numbers. Throws an exception derived
/// from std::exception for what is no finding, or one that this version does not know.
Finding parse_finding_record(const nlohmann::ordered_json& json);

/// The name that stands in the same object; nothing where there is none.
std::optional<Fingerprint> parse_finding_name(const nlohmann::ordered_json& json);

}  // namespace mapwright::validators
