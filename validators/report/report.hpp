// Findings of many maps, written in one of several formats.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "validators/fingerprint.hpp"
#include "validators/profile/suppressed_finding.hpp"

namespace mapwright::validators {

/// What a verb says of a map beside findings.
struct ReportSection {
  std::string key;   ///< member of the map's object in JSON; empty: not in JSON
  std::string json;  ///< its value
  std::string line;  ///< the same for people
};

/// What ended the check of a map before its end.
enum class Interruption : std::uint8_t { kNone, kTimeLimit, kMemoryLimit, kCrash };

/// What validation said of one map.
struct MapReport {
  std::string_view path;  ///< as messages name it
  std::string_view text;  ///< of the map, for excerpts; may be empty
  std::vector<Finding> findings;
  std::optional<std::string> unreadable;     ///< why the map could not be read at all, or judged
  std::vector<ReportSection> sections = {};  ///< behind the findings; of an unreadable map none
  Interruption interruption = Interruption::kNone;  ///< with `unreadable`: it was read, but …
  std::vector<Fingerprint> names = {};              ///< of the findings; empty: not known
  std::vector<SuppressedFinding> suppressed = {};   ///< what does not count

  /// True if the map could be read and nothing of severity error was found.
  bool passes() const { return !unreadable && !has_errors(findings); }
};

struct ReportOptions {
  std::string_view verb = "validate";  ///< names the schema "mapwright.<verb>/1"
  bool colour = false;                 ///< text on a terminal that shows colours
};

/// Writes a report map by map, so that only one of them need be in memory.
class ReportWriter {
 public:
  virtual ~ReportWriter() = default;
  virtual void map(const MapReport& report) = 0;
  /// True if `map` reads more of MapReport::text than the lines that findings name: only then must
  /// a report put together from parts find the maps again.
  virtual bool needs_whole_text() const { return false; }
  /// Call once behind the last map.
  virtual void finish() = 0;
};

/// A format: one file of this folder and one line in report_formats.def.
struct ReportFormat {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<ReportWriter> (*make)(std::ostream& out, const ReportOptions& options);
  bool is_binary = false;  ///< not for terminals
};

/// "time limit", "memory limit", "crash"; empty for none.
std::string_view to_string(Interruption interruption);

const std::vector<ReportFormat>& report_formats();

/// The format of that name; null where there is none.
const ReportFormat* find_report_format(std::string_view name);

}  // namespace mapwright::validators
