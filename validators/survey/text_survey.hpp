// One look at a map's text, which spares most texts being read as a whole.
#pragma once

#include <optional>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/progress.hpp"
#include "mapcore/text/document.hpp"
#include "validators/survey/survey.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// What a look at a text showed.
struct TextSurvey {
  /// Proven: `validate(read_map(text), options)` is empty.
  bool is_sound = false;
  /// Some obstacle may name the GIS feature it comes from (the token source=...).
  bool may_name_sources = true;
  Border border;  ///< where the text is sound
  /// Of all obstacles that `read_map` gives, where the look went to the end; `validate` takes it.
  std::optional<Survey> survey;
};

/// Looks at one obstacle after another and keeps its box alone: a third of the time and memory of
/// reading and validating a map. Looks no further once an obstacle is in doubt.
///
/// `progress` counts KiB of the text.
TextSurvey survey_text(const MapText& text, const ValidationOptions& options = {},
                       const Progress& progress = {});

/// As `validate` does, with what a look at the document's text showed. `progress` counts checks.
std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options,
                              std::optional<Survey> survey, const Progress& progress = {});

}  // namespace mapwright::validators
