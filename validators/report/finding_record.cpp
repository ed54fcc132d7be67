#include "validators/report/finding_record.hpp"

#include <stdexcept>
#include <string>

#include "validators/report/json.hpp"
#include "validators/report/lossless_text.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
std::optional<Value> get_optional(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional<Value>(value.get<Value>());
}

Severity severity_named(const std::string& name) {
  for (const Severity severity : {Severity::kNote, Severity::kWarning, Severity::kError}) {
    if (to_string(severity) == name) return severity;
  }
  throw std::invalid_argument("there is no severity " + name);
}

FindingCode code_named(const std::string& id) {
  if (const auto code = finding_code(id)) return *code;
  throw std::invalid_argument("there is no finding " + id);
}

std::vector<Point> parse_points(const Json& json) {
  std::vector<Point> points;
  for (const auto& p : json) points.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
  return points;
}

std::vector<std::vector<Point>> parse_lines(const Json& json) {
  std::vector<std::vector<Point>> lines;
  for (const auto& line : json) lines.push_back(parse_points(line));
  return lines;
}

DefectGeometry parse_geometry(const Json& json) {
  const Json none = Json::array();
  return {parse_points(json.value("points", none)), parse_lines(json.value("lines", none)),
          parse_lines(json.value("areas", none))};
}

TextEdit parse_edit(const Json& json) {
  const auto number = [&](const char* key) { return json.at(key).get<std::size_t>(); };
  return {{number("line"), number("column")},
          {number("end_line"), number("end_column")},
          get_text(json, "replacement")};
}

GisFeature parse_feature(const Json& json) {
  return {get_text(json, "source"), get_text(json, "layer"), json.at("fid").get<std::int64_t>()};
}

}  // namespace

Json finding_record_json(const Finding& finding, const Fingerprint* name) {
  Json json = Json::parse(finding_json(finding, name));
  put_text(json, "message", finding.message);
  for (std::size_t i = 0; i < finding.fix.size(); ++i) {
    put_text(json["fix"][i], "replacement", finding.fix[i].replacement);
  }
  for (std::size_t i = 0; i < finding.features.size(); ++i) {
    put_text(json["features"][i], "source", finding.features[i].source);
    put_text(json["features"][i], "layer", finding.features[i].layer);
  }
  return json;
}

// A member that is added to Finding stops the compiler here, until it is kept and read as well.
Finding parse_finding_record(const Json& json) {
  Finding finding{};
  auto& [code, severity, message, place, at, obstacle, segment, geometry, fix, features] = finding;
  code = code_named(json.at("code").get<std::string>());
  severity = severity_named(json.at("severity").get<std::string>());
  message = get_text(json, "message");
  if (const auto line = get_optional<std::size_t>(json, "line")) {
    place = TextPlace{*line, json.at("column").get<std::size_t>()};
  }
  const auto x = get_optional<double>(json, "x");
  const auto y = get_optional<double>(json, "y");
  if (x && y) at = Point{*x, *y};
  obstacle = get_optional<std::int64_t>(json, "obstacle");
  segment = get_optional<std::size_t>(json, "segment");
  if (json.contains("geometry")) geometry = parse_geometry(json.at("geometry"));
  for (const auto& edit : json.value("fix", Json::array())) fix.push_back(parse_edit(edit));
  for (const auto& feature : json.value("features", Json::array())) {
    features.push_back(parse_feature(feature));
  }
  return finding;
}

std::optional<Fingerprint> parse_finding_name(const Json& json) {
  if (!json.contains("fingerprint")) return std::nullopt;
  return Fingerprint{json.at("fingerprint").get<std::string>(),
                     json.at("subject_fingerprint").get<std::string>()};
}

}  // namespace mapwright::validators
