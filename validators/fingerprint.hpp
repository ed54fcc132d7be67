// Names of findings that survive the editing of a map.
#pragma once

#include <string>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright::validators {

/// Two names of one finding. A finding that an older report knows by either of them is the same
/// defect; 16 hexadecimal digits, with "-2", "-3" … behind them where several findings of one map
/// would share a name, in the order of the findings.
struct Fingerprint {
  /// Code and where on the map, to the millimetre; for findings of the text without such a place
  /// the record they stand in. Survives renumbered obstacles, moved lines, another layout.
  std::string place;
  /// Code, obstacle id and number of the segment. Survives moved obstacles, moved lines, another
  /// layout.
  std::string subject;

  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// One for each finding of a map, in their order. The document is the one the findings are about.
std::vector<Fingerprint> fingerprints(const MapDocument& document,
                                      const std::vector<Finding>& findings);

}  // namespace mapwright::validators
