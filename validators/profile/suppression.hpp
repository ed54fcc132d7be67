// Findings that somebody has looked at and accepts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "validators/fingerprint.hpp"
#include "validators/profile/date.hpp"

namespace mapwright::validators {

/// What a suppression covers: the findings for which all that is set holds.
struct Suppression {
  std::vector<FindingCode> codes;        ///< any of these; at least one
  std::optional<std::int64_t> obstacle;  ///< id
  std::optional<std::size_t> segment;    ///< 1-based, of that obstacle
  std::optional<Box> region;             ///< the finding's point lies in it (closed)
  std::string path;                      ///< a glob of map paths; empty: all maps
  std::string fingerprint;               ///< either name of the finding; empty: any

  std::string reason;         ///< never empty
  std::optional<Date> until;  ///< the last day on which it holds
  TextPlace place;            ///< in the configuration file
};

/// A map's finding as a suppression sees it.
struct Candidate {
  const Finding& finding;
  const Fingerprint& name;
  std::string_view path;  ///< of the map, from the folder of the configuration file, with '/'
};

bool covers(const Suppression& suppression, const Candidate& candidate);

/// True behind the last day of the suppression.
bool has_expired(const Suppression& suppression, Date today);

/// True if the glob matches the path: '*' and '?' stand for anything but '/', "**/" for any folders
/// or none, [a-z] for one of these; a glob without '/' is compared with the last part of the path.
bool glob_matches(std::string_view glob, std::string_view path);

}  // namespace mapwright::validators
