#include <nlohmann/json.hpp>
#include <stdexcept>

#include "validators/report/finding_record.hpp"
#include "validators/report/lossless_text.hpp"
#include "validators/report/map_record.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

Interruption interruption_named(const std::string& name) {
  for (const auto kind :
       {Interruption::kTimeLimit, Interruption::kMemoryLimit, Interruption::kCrash}) {
    if (to_string(kind) == name) return kind;
  }
  throw std::invalid_argument("there is no interruption " + name);
}

Json suppressed_json(const std::vector<SuppressedFinding>& all) {
  Json json = Json::array();
  for (const auto& [finding, name, by, reason] : all) {
    Json entry = finding_record_json(finding, &name);
    put_text(entry, "by", by);
    put_text(entry, "reason", reason);
    json.push_back(std::move(entry));
  }
  return json;
}

SuppressedFinding parse_suppressed(const Json& json) {
  return {parse_finding_record(json), parse_finding_name(json).value_or(Fingerprint{}),
          get_text(json, "by"), get_text(json, "reason")};
}

// The value of a section stands under its own key, as docs/cli.md has it.
void put_sections(Json& json, const std::vector<ReportSection>& sections) {
  Json lines = Json::array();
  for (const auto& section : sections) {
    if (!section.key.empty()) json[section.key] = Json::parse(section.json);
    Json line;
    line["key"] = section.key;
    put_text(line, "line", section.line);
    lines.push_back(std::move(line));
  }
  json["sections"] = std::move(lines);
}

std::vector<ReportSection> parse_sections(const Json& json) {
  std::vector<ReportSection> sections;
  for (const auto& line : json.at("sections")) {
    const auto key = line.at("key").get<std::string>();
    sections.push_back({key, key.empty() ? "" : dumped(json.at(key)), get_text(line, "line")});
  }
  return sections;
}

Json lines_json(const std::vector<QuotedLine>& lines) {
  Json json = Json::array();
  for (const auto& line : lines) {
    Json entry;
    entry["number"] = line.number;
    put_text(entry, "text", line.text);
    json.push_back(std::move(entry));
  }
  return json;
}

// Numbers rise from 1, so that the text they make is no longer than they say.
std::vector<QuotedLine> parse_lines(const Json& json) {
  std::vector<QuotedLine> lines;
  std::size_t last = 0;
  for (const auto& line : json) {
    lines.push_back({line.at("number").get<std::size_t>(), get_text(line, "text")});
    if (lines.back().number <= last) throw std::invalid_argument("lines out of order");
    last = lines.back().number;
  }
  return lines;
}

MapRecord record_of(const Json& json) {
  MapRecord record;
  record.path = get_text(json, "path");
  record.digest = json.at("digest").get<std::string>();
  if (json.contains("unreadable")) record.unreadable = get_text(json, "unreadable");
  if (json.contains("interrupted")) {
    record.interruption = interruption_named(json.at("interrupted").get<std::string>());
  }
  for (const auto& finding : json.at("findings")) {
    record.findings.push_back(parse_finding_record(finding));
    if (auto name = parse_finding_name(finding)) record.names.push_back(*std::move(name));
  }
  if (!record.names.empty() && record.names.size() != record.findings.size()) {
    throw std::invalid_argument("some findings have names, some have none");
  }
  for (const auto& entry : json.value("suppressed", Json::array())) {
    record.suppressed.push_back(parse_suppressed(entry));
  }
  record.sections = parse_sections(json);
  record.lines = parse_lines(json.at("lines"));
  return record;
}

}  // namespace

std::string record_json(const MapRecord& record) {
  const auto& [path, digest, findings, unreadable, sections, interruption, names, suppressed,
               lines] = record;
  Json json;
  put_text(json, "path", path);
  json["verdict"] = record.report({}).passes() ? "pass" : "fail";
  if (unreadable) put_text(json, "unreadable", *unreadable);
  if (interruption != Interruption::kNone) json["interrupted"] = to_string(interruption);
  json["findings"] = Json::array();
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Fingerprint* name = names.empty() ? nullptr : &names[i];
    json["findings"].push_back(finding_record_json(findings[i], name));
  }
  if (!suppressed.empty()) json["suppressed"] = suppressed_json(suppressed);
  put_sections(json, sections);
  json["lines"] = lines_json(lines);
  json["digest"] = digest;
  return dumped(json);
}

Result<MapRecord> parse_record(std::string_view json) {
  try {
    return record_of(Json::parse(json));
  } catch (const std::exception& error) {
    return input_failure(std::string("no record of a checked map: ") + error.what());
  }
}

}  // namespace mapwright::validators
