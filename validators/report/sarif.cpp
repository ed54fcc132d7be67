#include <algorithm>
#include <ostream>

#include "validators/check_pages.hpp"
#include "validators/report/sarif_result.hpp"

namespace mapwright::validators {
namespace {

using sarif::Json;

constexpr std::string_view kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

// Paths and messages may hold bytes that are not UTF-8; JSON may not.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Where the pages of docs/checks are on the web is known to who builds the program.
std::string help_uri(const FindingType& type) {
  const std::string docs = MAPWRIGHT_DOCS_URL;
  const std::string id(type.id);
  return docs.empty() ? "urn:mapwright:finding:" + id : docs + "/checks/" + id + ".md";
}

// "outline_self_intersection" → "OutlineSelfIntersection", as SARIF wants names to be.
std::string pascal_case(std::string_view name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') result += begins && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    begins = c == '_';
  }
  return result;
}

Json rule_json(FindingCode code) {
  const auto& type = finding_type(code);
  const std::string page(check_page(code));
  Json rule;
  rule["id"] = type.id;
  rule["name"] = pascal_case(type.name);
  rule["shortDescription"] = {{"text", type.summary}};
  rule["fullDescription"] = {{"text", std::string(type.summary) + "."}};
  rule["helpUri"] = help_uri(type);
  rule["help"] = {{"text", page}, {"markdown", page}};
  rule["defaultConfiguration"] = {{"level", to_string(type.severity)}};
  return rule;
}

Json artifact_json(const MapReport& report, const std::string& uri) {
  Json artifact;
  artifact["location"] = {{"uri", uri}};
  auto& properties = artifact["properties"];
  properties["verdict"] = report.passes() ? "pass" : "fail";
  for (const auto& section : report.sections) {
    if (!section.key.empty()) properties[section.key] = Json::parse(section.json);
  }
  return artifact;
}

/// A log of one run. Results come first, as the maps do; what they refer to (rules, maps) behind
/// them, each once.
class SarifReport : public ReportWriter {
 public:
  SarifReport(std::ostream& out, const ReportOptions& options) : out_(out), verb_(options.verb) {
    out_ << "{\n  \"$schema\": " << dumped(kSchema) << ",\n  \"version\": \"2.1.0\",\n"
         << "  \"runs\": [{\n    \"columnKind\": \"unicodeCodePoints\",\n    \"results\": [";
  }

  void map(const MapReport& report) override {
    const std::string uri = sarif::uri_of(report.path);
    const std::size_t artifact = artifacts_.size();
    artifacts_.push_back(dumped(artifact_json(report, uri)));
    if (report.unreadable) add_notification(*report.unreadable, uri, artifact);
    SourceLines lines(report.text);
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
      const Finding& finding = report.findings[i];
      const auto* name = i < report.names.size() ? &report.names[i] : nullptr;
      out_ << (first_ ? "\n" : ",\n") << "      "
           << dumped(
                  sarif::result_json(finding, name, {uri, artifact, rule_of(finding.code)}, lines));
      first_ = false;
    }
  }

  void finish() override {
    out_ << (first_ ? "]" : "\n    ]") << ",\n    \"artifacts\": [";
    for (std::size_t i = 0; i < artifacts_.size(); ++i) {
      out_ << (i == 0 ? "\n      " : ",\n      ") << artifacts_[i];
    }
    out_ << (artifacts_.empty() ? "]" : "\n    ]") << ",\n    \"invocations\": ["
         << dumped(invocation_json()) << "],\n    \"tool\": " << dumped(tool_json())
         << "\n  }]\n}\n";
  }

 private:
  std::size_t rule_of(FindingCode code) {
    const auto found = std::find(rules_.begin(), rules_.end(), code);
    if (found == rules_.end()) rules_.push_back(code);
    return static_cast<std::size_t>(std::find(rules_.begin(), rules_.end(), code) - rules_.begin());
  }

  void add_notification(const std::string& why, const std::string& uri, std::size_t artifact) {
    Json location;
    location["physicalLocation"]["artifactLocation"] = sarif::file_json(uri, artifact);
    Json notification;
    notification["level"] = "error";
    notification["message"] = sarif::message_json(why);
    notification["locations"] = Json::array({location});
    notifications_.push_back(std::move(notification));
  }

  Json invocation_json() const {
    Json invocation{{"executionSuccessful", notifications_.empty()}};
    if (!notifications_.empty()) invocation["toolExecutionNotifications"] = notifications_;
    return invocation;
  }

  Json tool_json() const {
    Json driver{{"name", "mapwright"},
                {"fullName", "mapwright " + verb_},
                {"semanticVersion", MAPWRIGHT_VERSION},
                {"rules", Json::array()}};
    for (const FindingCode code : rules_) driver["rules"].push_back(rule_json(code));
    return {{"driver", std::move(driver)}};
  }

  std::ostream& out_;
  std::string verb_;
  bool first_ = true;
  std::vector<FindingCode> rules_;  // that were broken, in the order of the results
  std::vector<std::string> artifacts_;
  Json notifications_ = Json::array();
};

}  // namespace

std::unique_ptr<ReportWriter> make_sarif_report(std::ostream& out, const ReportOptions& options) {
  return std::make_unique<SarifReport>(out, options);
}

}  // namespace mapwright::validators
