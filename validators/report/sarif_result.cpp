#include "validators/report/sarif_result.hpp"

#include "validators/report/json.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators::sarif {
namespace {

// unreserved and sub-delims of RFC 3986, and what paths are made of. A ':' in the first segment of
// a relative path would make a scheme of it.
bool is_plain_in_uri(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') ||
         std::string_view("-._~!$&'()*+,;=@/").find(c) != std::string_view::npos;
}

Json region_json(const TextPlace& place, SourceLines& lines) {
  const auto line = lines.line(place.line);
  const std::size_t end = field_end(line, place.column);
  Json region{{"startLine", place.line}, {"startColumn", place.column}, {"endColumn", end}};
  if (end > place.column) {
    region["snippet"] = {{"text", std::string(columns(line, place.column, end))}};
  }
  return region;
}

Json logical_location_json(const Finding& finding) {
  const std::string obstacle = "obstacle " + std::to_string(*finding.obstacle);
  if (!finding.segment) return {{"name", obstacle}, {"kind", "element"}};
  const std::string segment = "segment " + std::to_string(*finding.segment);
  return {{"name", segment}, {"fullyQualifiedName", obstacle + "/" + segment}, {"kind", "element"}};
}

Json location_json(const Finding& finding, const ResultContext& context, SourceLines& lines) {
  Json location;
  location["physicalLocation"]["artifactLocation"] = file_json(context.uri, context.artifact);
  if (finding.place) location["physicalLocation"]["region"] = region_json(*finding.place, lines);
  if (finding.obstacle) {
    location["logicalLocations"] = Json::array({logical_location_json(finding)});
  }
  return location;
}

Json replacement_json(const TextEdit& edit) {
  Json replacement;
  replacement["deletedRegion"] = {{"startLine", edit.begin.line},
                                  {"startColumn", edit.begin.column},
                                  {"endLine", edit.end.line},
                                  {"endColumn", edit.end.column}};
  replacement["insertedContent"] = {{"text", edit.replacement}};
  return replacement;
}

Json fix_json(const Finding& finding, const ResultContext& context) {
  Json change;
  change["artifactLocation"] = file_json(context.uri, context.artifact);
  for (const auto& edit : finding.fix) change["replacements"].push_back(replacement_json(edit));
  Json fix;
  fix["description"] = message_json("Repair " + std::string(finding_type(finding.code).name));
  fix["artifactChanges"] = Json::array({change});
  return fix;
}

// What SARIF has no words for: the place on the map and the GIS features.
Json properties_json(const Finding& finding) {
  const Json all = Json::parse(finding_json(finding));
  Json properties = Json::object();
  for (const auto* key : {"x", "y", "obstacle", "segment", "geometry", "features"}) {
    if (all.contains(key) && !all[key].is_null()) properties[key] = all[key];
  }
  return properties;
}

}  // namespace

std::string uri_of(std::string_view path) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    if (is_plain_in_uri(c)) {
      uri += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    uri += {'%', kDigits[byte >> 4U], kDigits[byte & 0xFU]};
  }
  return uri;
}

Json message_json(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '{' || c == '}') escaped += c;
    escaped += c;
  }
  return {{"text", escaped}};
}

Json file_json(std::string_view uri, std::size_t artifact) {
  return {{"uri", uri}, {"index", artifact}};
}

Json result_json(const Finding& finding, const Fingerprint* name, const ResultContext& context,
                 SourceLines& lines) {
  Json result;
  result["ruleId"] = finding_type(finding.code).id;
  result["ruleIndex"] = context.rule;
  result["level"] = to_string(finding.severity);
  result["message"] = message_json(message_text(finding));
  result["locations"] = Json::array({location_json(finding, context, lines)});
  if (name != nullptr) {
    result["partialFingerprints"] = {{"mapwrightPlace/v1", name->place},
                                     {"mapwrightSubject/v1", name->subject}};
  }
  if (!finding.fix.empty()) result["fixes"] = Json::array({fix_json(finding, context)});
  if (Json properties = properties_json(finding); !properties.empty()) {
    result["properties"] = std::move(properties);
  }
  return result;
}

}  // namespace mapwright::validators::sarif
