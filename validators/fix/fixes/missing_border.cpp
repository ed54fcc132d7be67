#include <algorithm>
#include <cmath>

#include "mapcore/text/characters.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

// What lost records would add to the extent is not known.
bool all_is_read(const FixContext& context) {
  return std::none_of(context.findings.begin(), context.findings.end(), [](const Finding& f) {
    const char family = finding_type(f.code).id.front();
    return (family == 'F' && f.code != FindingCode::F104 && f.code != FindingCode::F113) ||
           f.code == FindingCode::G102;
  });
}

}  // namespace

Proposals fix_missing_border(const FixContext& context) {
  const auto& document = context.document;
  if (!is_found(context, FindingCode::F104) || !all_is_read(context)) return {};
  const Box all = extent(document.map);
  if (all.is_empty()) return {};
  constexpr double kMargin_m = 1.0;
  const std::string record = "border;\n" + number_text(std::floor(all.min_x) - kMargin_m) + ";" +
                             number_text(std::ceil(all.max_y) + kMargin_m) + ";\n" +
                             number_text(std::ceil(all.max_x) + kMargin_m) + ";" +
                             number_text(std::floor(all.min_y) - kMargin_m) + ";\n#\n";
  const std::size_t first = document.index.obstacle_offsets.front();
  return {{FindingCode::F104,
           {},
           "a border written around all obstacles, at least 1 m away from them",
           {{first, first, record}}}};
}

}  // namespace mapwright::validators
