// Findings as one HTML page with maps to look at.
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <span>

#include "mapcore/text/reader.hpp"
#include "validators/check_pages.hpp"
#include "validators/report/html/page.hpp"
#include "validators/report/html/scene.hpp"
#include "validators/report/json.hpp"
#include "validators/report/report.hpp"
#include "validators/report/source_lines.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// As finding_json, and the line it was found in.
std::string row_json(const Finding& finding, SourceLines& lines) {
  std::string json = finding_json(finding);
  if (!finding.place) return json;
  const auto line = lines.line(finding.place->line);
  json.pop_back();
  return json + ",\"excerpt\":" + dumped(excerpt(line, finding.place->column)) + "}";
}

std::string found_json(const MapReport& report) {
  std::string json = "{\"path\":" + dumped(std::string(report.path)) + ",\"verdict\":";
  json += report.passes() ? "\"pass\"" : "\"fail\"";
  if (report.unreadable) json += ",\"unreadable\":" + dumped(*report.unreadable);
  json += ",\"sections\":[";
  for (std::size_t i = 0; i < report.sections.size(); ++i) {
    json += (i == 0 ? "{\"line\":" : ",{\"line\":") + dumped(report.sections[i].line) + "}";
  }
  json += "],\"findings\":[";
  SourceLines lines(report.text);
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    json += (i == 0 ? "\n" : ",\n") + row_json(report.findings[i], lines);
  }
  return json + "]}";
}

Point point_of(const Json& xy) {
  return {xy.at(0).get<double>(), xy.at(1).get<double>()};
}

// What `check` says of places (docs/cli.md): areas out of reach, pairs without path.
void add_section(const ReportSection& section, std::size_t unreachable, std::size_t missed,
                 SceneWriter& scene) {
  if (section.key != "reachability" && section.key != "planning") return;
  const Json json = Json::parse(section.json);
  if (!json.is_object()) return;
  for (const auto& area : json.value("unreachable", Json::array())) {
    const auto& box = area.at("bbox");
    scene.box(unreachable, {box.at(0).get<double>(), box.at(1).get<double>(),
                            box.at(2).get<double>(), box.at(3).get<double>()});
  }
  for (const auto& pair : json.value("missed", Json::array())) {
    const Point ends[] = {point_of(pair.at("start")), point_of(pair.at("goal"))};
    scene.line(missed, ends, true);
  }
}

std::string scene_json(const MapReport& report) {
  const Map map = read_map(std::string(report.text)).map;
  auto layers = kind_layers();
  const std::size_t unreachable = layers.size();
  layers.push_back({"area out of reach", "unreachable"});
  layers.push_back({"pair without path", "missed"});
  SceneWriter scene(map.border, std::move(layers));
  add_map(scene, map);
  for (const auto& section : report.sections) {
    add_section(section, unreachable, unreachable + 1, scene);
  }
  return scene.json();
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

class HtmlReport : public ReportWriter {
 public:
  HtmlReport(std::ostream& out, const ReportOptions& options) : page_(out), verb_(options.verb) {}

  void map(const MapReport& report) override {
    page_.map(found_json(report), scene_json(report));
    ++maps_;
    passed_ += report.passes() ? 1 : 0;
    for (const auto& finding : report.findings) codes_.insert(finding.code);
  }

  bool needs_whole_text() const override { return true; }

  void finish() override {
    PageWords words;
    words.title = "mapwright " + verb_;
    words.summary = counted(maps_, "map") + ": " + std::to_string(passed_) + " fit, " +
                    std::to_string(maps_ - passed_) + " not";
    words.levels = {{"error", "error"}, {"warning", "warning"}, {"note", "note"}};
    words.columns = {"severity", "code", "line", "obstacle", "message"};
    words.codes_json = codes_json();
    page_.finish(words);
  }

 private:
  // Name and page of each code that was found.
  std::string codes_json() const {
    Json json = Json::object();
    for (const auto code : codes_) {
      const auto& type = finding_type(code);
      json[std::string(type.id)] = {{"name", type.name}, {"page", check_page(code)}};
    }
    return dumped(json);
  }

  ViewerPage page_;
  std::string verb_;
  std::size_t maps_ = 0, passed_ = 0;
  std::set<FindingCode> codes_;
};

}  // namespace

std::unique_ptr<ReportWriter> make_html_report(std::ostream& out, const ReportOptions& options) {
  return std::make_unique<HtmlReport>(out, options);
}

}  // namespace mapwright::validators
