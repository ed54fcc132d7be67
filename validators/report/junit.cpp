#include <ostream>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "mapcore/text/characters.hpp"
#include "validators/report/report.hpp"
#include "validators/report/source_lines.hpp"
#include "validators/report/text.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// Some schemas demand a time. The hour of the run would make each report another one, and says
// nothing of the map: it is the one that reproducible builds use.
constexpr const char* kTimestamp = "1970-01-01T00:00:00";

// XML 1.0 has no way to write control characters, U+FFFE and U+FFFF.
bool is_in_xml(std::string_view character) {
  if (character.size() > 1) return character != "\xEF\xBF\xBE" && character != "\xEF\xBF\xBF";
  const char c = character.front();
  return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::string xml_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = text::utf8_sequence_length(text);
    const bool is_character = length > 0 && is_in_xml(text.substr(0, length));
    result += is_character ? text.substr(0, length) : kReplacement;
    text.remove_prefix(length > 0 ? length : 1);
  }
  return result;
}

void set(pugi::xml_node node, const char* name, std::string_view value) {
  node.append_attribute(name) = xml_text(value).c_str();
}

void set(pugi::xml_node node, const char* name, std::size_t value) {
  node.append_attribute(name) = static_cast<unsigned long long>(value);
}

void add_text(pugi::xml_node node, std::string_view text) {
  node.append_child(pugi::node_pcdata).set_value(xml_text(text).c_str());
}

std::string excerpt_of(const Finding& finding, SourceLines& lines) {
  if (!finding.place) return "";
  return excerpt(lines.line(finding.place->line), finding.place->column);
}

// "G104 outline_self_intersection: obstacle 26, segment 3": the same after lines have moved.
std::string case_name(const Finding& finding) {
  const auto& type = finding_type(finding.code);
  std::string name = std::string(type.id) + " " + std::string(type.name);
  if (finding.obstacle) name += ": obstacle " + std::to_string(*finding.obstacle);
  if (finding.segment) name += ", segment " + std::to_string(*finding.segment);
  return name;
}

/// A map as a test suite: a failed test for each finding of severity error, or one that passes.
/// Warnings and notes fail nothing; they are what the suite printed.
class Suite {
 public:
  Suite(const MapReport& report, const ReportOptions& options, std::size_t number)
      : report_(report), verb_(options.verb), suite_(document_.append_child("testsuite")) {
    set(suite_, "name", report.path);
    set(suite_, "timestamp", kTimestamp);
    set(suite_, "hostname", "localhost");
    suite_.append_child("properties");
    add_cases();
    set(suite_, "tests", tests_);
    set(suite_, "failures", failures_);
    set(suite_, "errors", report.unreadable ? 1 : 0);
    set(suite_, "time", "0");
    set(suite_, "package", "mapwright." + std::string(verb_));
    set(suite_, "id", number);
    suite_.append_child("system-out");
    add_text(suite_.child("system-out"), printed_);
    suite_.append_child("system-err");
  }

  void write(std::ostream& out) const {
    suite_.print(out, "  ", pugi::format_indent, pugi::encoding_utf8, 1);
  }

 private:
  void add_cases() {
    if (report_.unreadable) {
      pugi::xml_node error = add_case("can be read").append_child("error");
      set(error, "message", *report_.unreadable);
      set(error, "type", "unreadable");
      return;
    }
    SourceLines lines(report_.text);
    for (const auto& finding : report_.findings) {
      const std::string text =
          finding_line(report_.path, finding) + "\n" + excerpt_of(finding, lines);
      finding.severity == Severity::kError ? add_failure(finding, text) : void(printed_ += text);
    }
    if (failures_ == 0) add_case("has no finding of severity error");
    for (const auto& section : report_.sections) {
      if (!section.line.empty()) printed_ += section.line + "\n";
    }
  }

  pugi::xml_node add_case(std::string_view name) {
    pugi::xml_node test = suite_.append_child("testcase");
    set(test, "name", name);
    set(test, "classname", report_.path);
    set(test, "time", "0");
    ++tests_;
    return test;
  }

  void add_failure(const Finding& finding, const std::string& text) {
    pugi::xml_node failure = add_case(case_name(finding)).append_child("failure");
    set(failure, "message", message_text(finding));
    set(failure, "type", finding_type(finding.code).id);
    add_text(failure, text);
    ++failures_;
  }

  const MapReport& report_;
  std::string_view verb_;
  pugi::xml_document document_;
  pugi::xml_node suite_;
  std::size_t tests_ = 0, failures_ = 0;
  std::string printed_;
};

class JunitReport : public ReportWriter {
 public:
  JunitReport(std::ostream& out, const ReportOptions& options) : out_(out), options_(options) {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  }

  void map(const MapReport& report) override { Suite(report, options_, number_++).write(out_); }
  void finish() override { out_ << "</testsuites>\n"; }

 private:
  std::ostream& out_;
  ReportOptions options_;
  std::size_t number_ = 0;
};

}  // namespace

std::unique_ptr<ReportWriter> make_junit_report(std::ostream& out, const ReportOptions& options) {
  return std::make_unique<JunitReport>(out, options);
}

}  // namespace mapwright::validators
