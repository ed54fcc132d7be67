// The answer of `mapwright localizability`.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "navcore/localizability/filter_confirmation.hpp"
#include "navcore/localizability/localizability.hpp"

namespace mapwright::cli {

struct LocalizabilityAnswer {
  navcore::LocalizabilitySettings settings;
  navcore::WeaknessLimits limits;
  const navcore::LocalizabilityField& field;
  navcore::LocalizabilitySummary summary;
  std::vector<navcore::WeakArea> areas;
  std::optional<navcore::Confirmation> confirmation;  ///< with --confirm
  std::string output;                                 ///< the file written; empty: none
};

void write_localizability_json(std::ostream& out, const LocalizabilityAnswer& answer);
void write_localizability_text(std::ostream& out, const LocalizabilityAnswer& answer);

}  // namespace mapwright::cli
