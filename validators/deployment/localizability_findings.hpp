// What is told of the areas where a robot cannot know its place.
#pragma once

#include <vector>

#include "mapcore/finding.hpp"
#include "navcore/localizability/localizability.hpp"

namespace mapwright::validators {

/// N107 and N108: one finding an area, of each weakness the `most` largest; the last of them counts
/// the rest. `areas` are of the field.
std::vector<Finding> localizability_findings(const navcore::LocalizabilityField& field,
                                             const std::vector<navcore::WeakArea>& areas,
                                             std::size_t most = 5);

/// The message of one of them.
std::string weak_area_text(const navcore::LocalizabilityField& field,
                           const navcore::WeakArea& area);

}  // namespace mapwright::validators
