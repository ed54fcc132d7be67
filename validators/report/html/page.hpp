// One HTML page with maps to look at: for reports, and for differences of two maps.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace mapwright::validators {

/// What rows of the page's table can be: "error" …, with the style sheet's name of its colour.
struct PageLevel {
  std::string name, colour;
};

/// What stands on the page beside maps.
struct PageWords {
  std::string title;
  std::string summary;               ///< one line beside the title
  std::vector<PageLevel> levels;     ///< most important first
  std::vector<std::string> columns;  ///< of the table: severity, code, line, obstacle, message
  std::string codes_json = "{}";     ///< object of codes: {"name", "page"}
};

/// Writes a page that needs nothing but itself: style, script and data stand in it, and its Content
/// Security Policy forbids the browser to load anything or to run any other script. Maps are
/// written one by one, so that only one of them need be in memory.
class ViewerPage {
 public:
  explicit ViewerPage(std::ostream& out);

  /// A map. `found_json`: {"path", "verdict", "unreadable", "sections": [{"line"}], "findings":
  /// […]} with findings as finding_json writes them, and "excerpt"; `scene_json`: of SceneWriter.
  void map(std::string_view found_json, std::string_view scene_json);

  /// Call once behind the last map.
  void finish(const PageWords& words);

 private:
  void data_block(std::string_view attributes, std::string_view json);

  std::ostream& out_;
};

}  // namespace mapwright::validators
