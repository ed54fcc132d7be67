#include "validators/validator.hpp"

#include <array>
#include <iterator>
#include <utility>

#include "validators/check.hpp"
#include "validators/survey/text_survey.hpp"

namespace mapwright::validators {
namespace {

constexpr std::array kChecks{
#define MAPWRIGHT_CHECK(name) &check_##name,
#include "validators/checks.def"
#undef MAPWRIGHT_CHECK
};

std::vector<Finding> validate(const CheckContext& context, const Progress& progress) {
  FindingSink sink(context.document());
  for (std::size_t i = 0; i < kChecks.size(); ++i) {
    kChecks[i](context, sink);
    if (progress) progress(i + 1, kChecks.size());
  }
  std::vector<Finding> findings = context.document().findings;
  auto found = sink.take();
  findings.insert(findings.end(), std::make_move_iterator(found.begin()),
                  std::make_move_iterator(found.end()));
  sort_findings(findings);
  return findings;
}

}  // namespace

std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options) {
  return validate(document, options, Proofs::kAll);
}

std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options,
                              Proofs proofs) {
  return validate(CheckContext(document, options, proofs), {});
}

std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options,
                              std::optional<Survey> survey, const Progress& progress) {
  if (!survey) survey.emplace(document.map, options, Proofs::kAll);
  return validate(CheckContext(document, options, *std::move(survey)), progress);
}

}  // namespace mapwright::validators
