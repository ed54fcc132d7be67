// Private to this folder: A finding as a result of SARIF 2.1.0.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "validators/report/report.hpp"
#include "validators/report/source_lines.hpp"

namespace mapwright::validators::sarif {

using Json = nlohmann::ordered_json;

/// A path as a URI reference (RFC 3986): relative ones stay so, absolute ones get the scheme file.
std::string uri_of(std::string_view path);

/// A message object; braces are doubled, since single ones are placeholders (SARIF, 3.11.5).
Json message_json(std::string_view text);

/// The file as an artifactLocation.
Json file_json(std::string_view uri, std::size_t artifact);

struct ResultContext {
  std::string_view uri;      ///< of the map
  std::size_t artifact = 0;  ///< position among the run's artifacts
  std::size_t rule = 0;      ///< position among the run's rules
};

/// The result object of a finding: rule, message, region of the field it names, logical location
/// (obstacle and segment), fingerprints, fix, and in its property bag the place on the map.
Json result_json(const Finding& finding, const Fingerprint* name, const ResultContext& context,
                 SourceLines& lines);

}  // namespace mapwright::validators::sarif
