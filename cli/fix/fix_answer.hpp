// What `mapwright fix` says it did.
#pragma once

#include <iosfwd>
#include <string_view>

#include "validators/fix/fix_map.hpp"
#include "validators/profile/judge.hpp"

namespace mapwright::cli {

struct FixAnswer {
  std::string_view path;    ///< of the map, as messages name it
  std::string_view output;  ///< of the repaired one; the map's own where it is not written
  const validators::FixOutcome& outcome;
  const std::vector<Finding>& remaining;  ///< findings of the repaired map, as the site judges them
  std::string_view diff;                  ///< of a dry run; empty where there is none
};

/// Lines for people: what was done, what was undone, how far anything moved, what remains.
void write_fix_text(std::ostream& out, const FixAnswer& answer);

/// The schema mapwright.fix/1 (docs/cli.md).
void write_fix_json(std::ostream& out, const FixAnswer& answer);

}  // namespace mapwright::cli
