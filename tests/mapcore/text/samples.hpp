// A small map that tests damage, and findings in a form that is quick to compare.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "mapcore/finding.hpp"

namespace mapwright::test {

/// A triangle, one field list a line, so that lines and columns are easy to count:
///
///      1 border;      5 obstacle;          8 0;0;           12 1;0;          16 0;1;
///      2 -4;58;       6 1;1;3;column;      9 1;0;           13 0;1;          17 0;0;
///      3 58;-4;       7 #                 10 5;1;wall;      14 5;1;door;     18 5;1;wall;
///      4 #                                11 #              15 #             19 #
inline const std::string kTriangle =
    "border;\n-4;58;\n58;-4;\n#\n"
    "obstacle;\n1;1;3;column;\n#\n"
    "0;0;\n1;0;\n5;1;wall;\n#\n"
    "1;0;\n0;1;\n5;1;door;\n#\n"
    "0;1;\n0;0;\n5;1;wall;\n#\n";

/// `text` with the first `what` replaced.
inline std::string with(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

/// Code, line and column of a finding, obstacle and segment.
struct Report {
  std::string code;
  std::size_t line = 0;
  std::size_t column = 0;
  std::optional<std::int64_t> obstacle{};
  std::optional<std::size_t> segment{};

  friend bool operator==(const Report&, const Report&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Report& report) {
    out << report.code << " at " << report.line << ':' << report.column;
    if (report.obstacle) out << " obstacle " << *report.obstacle;
    if (report.segment) out << " segment " << *report.segment;
    return out;
  }
};

inline std::vector<Report> reports(const std::vector<Finding>& findings) {
  std::vector<Report> result;
  for (const auto& finding : findings) {
    result.push_back({std::string(finding_type(finding.code).id), finding.place->line,
                      finding.place->column, finding.obstacle, finding.segment});
  }
  return result;
}

}  // namespace mapwright::test
