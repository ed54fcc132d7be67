// A baseline: the findings of an earlier run, which are no news.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/result.hpp"
#include "validators/fingerprint.hpp"

namespace mapwright::validators {

/// A finding that the baseline knows.
struct KnownFinding {
  FindingCode code;
  Fingerprint name;
  std::string message;  ///< for people who read the file

  friend bool operator==(const KnownFinding&, const KnownFinding&) = default;
};

/// Findings by map. Paths are as seen from the folder of the baseline file, with '/'.
class Baseline {
 public:
  /// Failure (kInput): the text is no baseline of schema mapwright.baseline/1.
  static Result<Baseline> parse(const std::string& text);

  void add(const std::string& path, std::vector<KnownFinding> findings);

  /// The findings of a map; none for a map it does not know.
  const std::vector<KnownFinding>& findings(const std::string& path) const;

  /// The file: maps by path, findings in their order.
  std::string text() const;

 private:
  std::map<std::string, std::vector<KnownFinding>> maps_;
};

/// Which of `findings` are among the known ones: first those known by place, of the rest those
/// known by subject. A known finding stands for one finding.
std::vector<bool> known_among(const std::vector<KnownFinding>& known,
                              const std::vector<Finding>& findings,
                              const std::vector<Fingerprint>& names);

}  // namespace mapwright::validators
