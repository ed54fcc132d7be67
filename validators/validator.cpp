#include "validators/validator.hpp"

#include <array>
#include <iterator>

#include "validators/check.hpp"

namespace mapwright::validators {
namespace {

constexpr std::array kChecks{
#define MAPWRIGHT_CHECK(name) &check_##name,
#include "validators/checks.def"
#undef MAPWRIGHT_CHECK
};

}  // namespace

std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options) {
  return validate(document, options, Proofs::kAll);
}

std::vector<Finding> validate(const MapDocument& document, const ValidationOptions& options,
                              Proofs proofs) {
  const CheckContext context(document, options, proofs);
  FindingSink sink(document);
  for (const auto check : kChecks) check(context, sink);

  std::vector<Finding> findings = document.findings;
  auto found = sink.take();
  findings.insert(findings.end(), std::make_move_iterator(found.begin()),
                  std::make_move_iterator(found.end()));
  sort_findings(findings);
  return findings;
}

}  // namespace mapwright::validators
