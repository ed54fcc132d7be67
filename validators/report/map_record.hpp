// What was said of one map, kept: on its way between processes, in a journal, in part of a report.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/result.hpp"
#include "validators/report/report.hpp"

namespace mapwright::validators {

/// A line of the map that a finding names.
struct QuotedLine {
  std::size_t number = 1;
  std::string text;  ///< as far as excerpts show it

  friend bool operator==(const QuotedLine&, const QuotedLine&) = default;
};

/// A MapReport that owns what it holds. Of the map's text it keeps the lines that findings name.
struct MapRecord {
  std::string path;    ///< as messages name it
  std::string digest;  ///< of what was read; empty where nothing could be
  std::vector<Finding> findings;
  std::optional<std::string> unreadable;
  std::vector<ReportSection> sections;
  Interruption interruption = Interruption::kNone;
  std::vector<Fingerprint> names;  ///< of the findings; empty: not known
  std::vector<SuppressedFinding> suppressed;
  std::vector<QuotedLine> lines;  ///< by number

  /// A text in which those lines have their numbers, and all others are empty.
  std::string quoted_text() const;

  /// The report, of that text or the map's own. Refers to this record and to the text.
  MapReport report(std::string_view text) const;
};

MapRecord make_record(const MapReport& report, std::string digest);

/// One line of JSON: the keys that docs/cli.md gives a map, and what else a report needs. Reading
/// it back gives the same record; bytes that are not UTF-8 survive.
std::string record_json(const MapRecord& record);

/// Failure (kInput): it is no record, or one of another version.
Result<MapRecord> parse_record(std::string_view json);

}  // namespace mapwright::validators
