#include "validators/report/json.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

#include "validators/report/report.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// Paths and messages may hold bytes that are not UTF-8; JSON may not.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json point_json(Point p) {
  return {p.x, p.y};
}

Json points_json(const std::vector<Point>& points) {
  Json json = Json::array();
  for (const Point p : points) json.push_back(point_json(p));
  return json;
}

Json lines_json(const std::vector<std::vector<Point>>& lines) {
  Json json = Json::array();
  for (const auto& line : lines) json.push_back(points_json(line));
  return json;
}

Json geometry_json(const DefectGeometry& geometry) {
  Json json = Json::object();
  if (!geometry.points.empty()) json["points"] = points_json(geometry.points);
  if (!geometry.lines.empty()) json["lines"] = lines_json(geometry.lines);
  if (!geometry.areas.empty()) json["areas"] = lines_json(geometry.areas);
  return json;
}

Json edit_json(const TextEdit& edit) {
  return {{"line", edit.begin.line},
          {"column", edit.begin.column},
          {"end_line", edit.end.line},
          {"end_column", edit.end.column},
          {"replacement", edit.replacement}};
}

Json feature_json(const GisFeature& feature) {
  return {{"source", feature.source}, {"layer", feature.layer}, {"fid", feature.fid}};
}

class JsonReport : public ReportWriter {
 public:
  JsonReport(std::ostream& out, const ReportOptions& options) : out_(out) {
    out_ << "{\n  \"schema\": " << dumped("mapwright." + std::string(options.verb) + "/1")
         << ",\n  \"maps\": [";
  }

  void map(const MapReport& report) override {
    out_ << (first_ ? "\n" : ",\n") << "    {\n      \"path\": " << dumped(std::string(report.path))
         << ",\n      \"verdict\": " << (report.passes() ? "\"pass\"" : "\"fail\"");
    if (report.unreadable) out_ << ",\n      \"unreadable\": " << dumped(*report.unreadable);
    if (report.interruption != Interruption::kNone) {
      out_ << ",\n      \"interrupted\": " << dumped(std::string(to_string(report.interruption)));
    }
    write_findings(report);
    write_suppressed(report.suppressed);
    for (const auto& section : report.sections) {
      if (!section.key.empty()) out_ << ",\n      " << dumped(section.key) << ": " << section.json;
    }
    out_ << "\n    }";
    first_ = false;
  }

  void finish() override { out_ << (first_ ? "]" : "\n  ]") << "\n}\n"; }

 private:
  void write_findings(const MapReport& report) {
    const bool has_names = report.names.size() == report.findings.size();
    out_ << ",\n      \"findings\": [";
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
      out_ << (i == 0 ? "\n        " : ",\n        ")
           << finding_json(report.findings[i], has_names ? &report.names[i] : nullptr);
    }
    out_ << (report.findings.empty() ? "]" : "\n      ]");
  }

  // The finding's own keys, and behind them who set it aside and why.
  void write_suppressed(const std::vector<SuppressedFinding>& suppressed) {
    if (suppressed.empty()) return;
    out_ << ",\n      \"suppressed\": [";
    for (std::size_t i = 0; i < suppressed.size(); ++i) {
      std::string json = finding_json(suppressed[i].finding, &suppressed[i].name);
      json.pop_back();
      out_ << (i == 0 ? "\n        " : ",\n        ") << json
           << ",\"by\":" << dumped(suppressed[i].by)
           << ",\"reason\":" << dumped(suppressed[i].reason) << "}";
    }
    out_ << "\n      ]";
  }

  std::ostream& out_;
  bool first_ = true;
};

}  // namespace

std::string finding_json(const Finding& finding, const Fingerprint* name) {
  Json json;
  json["code"] = finding_type(finding.code).id;
  json["severity"] = to_string(finding.severity);
  json["message"] = finding.message;
  json["line"] = finding.place ? Json(finding.place->line) : Json(nullptr);
  json["column"] = finding.place ? Json(finding.place->column) : Json(nullptr);
  json["x"] = finding.at ? Json(finding.at->x) : Json(nullptr);
  json["y"] = finding.at ? Json(finding.at->y) : Json(nullptr);
  json["obstacle"] = or_null(finding.obstacle);
  json["segment"] = or_null(finding.segment);
  if (!finding.geometry.empty()) json["geometry"] = geometry_json(finding.geometry);
  for (const auto& edit : finding.fix) json["fix"].push_back(edit_json(edit));
  for (const auto& feature : finding.features) json["features"].push_back(feature_json(feature));
  if (name != nullptr) {
    json["fingerprint"] = name->place;
    json["subject_fingerprint"] = name->subject;
  }
  return dumped(json);
}

std::unique_ptr<ReportWriter> make_json_report(std::ostream& out, const ReportOptions& options) {
  return std::make_unique<JsonReport>(out, options);
}

}  // namespace mapwright::validators
