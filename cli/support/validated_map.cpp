#include "cli/support/validated_map.hpp"

#include <utility>

#include "cli/support/files.hpp"
#include "cli/support/heap.hpp"
#include "cli/support/map_files.hpp"
#include "mapcore/text/reader.hpp"
#include "validators/survey/text_survey.hpp"

namespace mapwright::cli {
namespace {

// A look keeps no more than one byte for so many of the text.
constexpr std::size_t kTextPerSurvey = 4;

ValidatedMap without_obstacles(MapText text, const Border& border) {
  ValidatedMap result;
  result.document.text = std::move(text);
  result.document.map.border = border;
  result.is_read = false;
  return result;
}

}  // namespace

ValidatedMap validated_text(MapText text, const validators::ValidationOptions& options,
                            const Progress& progress, bool needs_sources) {
  expect_memory(text.size() / kTextPerSurvey);
  auto look = validators::survey_text(text, options, progress);
  if (look.is_sound && !(needs_sources && look.may_name_sources)) {
    return without_obstacles(std::move(text), look.border);
  }
  expect_map_of(text.size());
  ValidatedMap result;
  result.document = read_map(std::move(text), progress);
  result.findings =
      validators::validate(result.document, options, std::move(look.survey), progress);
  return result;
}

ValidatedMap validated_file(const std::string& path, const validators::ValidationOptions& options,
                            const Progress& progress, bool needs_sources) {
  return validated_text(read_map_text(path), options, progress, needs_sources);
}

}  // namespace mapwright::cli
