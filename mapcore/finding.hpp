// Findings: what is wrong with a map, where, and how bad it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright {

enum class Severity : std::uint8_t { kNote, kWarning, kError };

std::string_view to_string(Severity severity);

/// The defects of finding_catalogue.def.
enum class FindingCode : std::uint16_t {
#define MAPWRIGHT_FINDING(code, name, severity, summary) code,
#include "mapcore/finding_catalogue.def"
#undef MAPWRIGHT_FINDING
};

/// What the catalogue says of a code.
struct FindingType {
  FindingCode code;
  std::string_view id;       ///< "G104"
  std::string_view name;     ///< "outline_self_intersection"
  Severity severity;         ///< unless a profile says otherwise
  std::string_view summary;  ///< one line, without a full stop
};

/// All types, in the order of the catalogue.
const std::vector<FindingType>& finding_catalogue();
const FindingType& finding_type(FindingCode code);
std::optional<FindingCode> finding_code(std::string_view id);

/// A place in a text: 1-based line, 1-based column counted in characters (code points).
struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;

  friend bool operator==(const TextPlace&, const TextPlace&) = default;
};

/// What is wrong, as a GIS editor shows it: metres, map frame. Empty where `Finding::at` says it
/// all or nothing has a place.
struct DefectGeometry {
  std::vector<Point> points;              ///< crossings, ends that do not meet
  std::vector<std::vector<Point>> lines;  ///< segments, chains, gaps; two points or more each
  std::vector<std::vector<Point>> areas;  ///< rings of three points or more, the first not repeated

  bool empty() const { return points.empty() && lines.empty() && areas.empty(); }
  friend bool operator==(const DefectGeometry&, const DefectGeometry&) = default;
};

/// Puts `replacement` in the place of the text from `begin` up to but not including `end`; inserts
/// it where they are equal.
struct TextEdit {
  TextPlace begin, end;
  std::string replacement;

  friend bool operator==(const TextEdit&, const TextEdit&) = default;
};

/// A feature of a GIS source, as the ledger of `convert` names it.
struct GisFeature {
  std::string source;  ///< path as the ledger has it
  std::string layer;
  std::int64_t fid = 0;

  friend bool operator==(const GisFeature&, const GisFeature&) = default;
};

/// One defect. Only what is known is set.
struct Finding {
  FindingCode code;
  Severity severity;
  std::string message;  ///< what is wrong, where, what to do; no code, no full stop
  std::optional<TextPlace> place;
  std::optional<Point> at;               ///< metres, map frame
  std::optional<std::int64_t> obstacle;  ///< id of the obstacle to blame
  std::optional<std::size_t> segment;    ///< 1-based number of the segment within that obstacle
  DefectGeometry geometry = {};
  /// A proven repair: edits that do not overlap, in the order of the text. After all of them this
  /// finding is gone and no new one has come (tests hold every fixture to it). Empty: none is
  /// known.
  std::vector<TextEdit> fix = {};
  std::vector<GisFeature> features = {};  ///< of which the obstacle was made, where that is known

  friend bool operator==(const Finding&, const Finding&) = default;
};

/// A finding with the catalogue's severity.
Finding make_finding(FindingCode code, std::string message);

/// True if one of them has severity error.
bool has_errors(const std::vector<Finding>& findings);

/// Order for people: by line, column, code; findings without place last. Stable.
void sort_findings(std::vector<Finding>& findings);

}  // namespace mapwright
