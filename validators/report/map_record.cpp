#include "validators/report/map_record.hpp"

#include <algorithm>
#include <map>

#include "validators/report/source_lines.hpp"

namespace mapwright::validators {
namespace {

/// By line, the greatest column that a finding names in it.
class NamedColumns {
 public:
  void add(const Finding& finding) {
    if (!finding.place) return;
    auto& column = columns_[finding.place->line];
    column = std::max(column, finding.place->column);
  }
  const std::map<std::size_t, std::size_t>& columns() const { return columns_; }

 private:
  std::map<std::size_t, std::size_t> columns_;
};

}  // namespace

MapRecord make_record(const MapReport& report, std::string digest) {
  const auto& [path, text, findings, unreadable, sections, interruption, names, suppressed] =
      report;
  MapRecord record{std::string(path),
                   std::move(digest),
                   findings,
                   unreadable,
                   sections,
                   interruption,
                   names,
                   suppressed,
                   {}};
  NamedColumns named;
  for (const auto& finding : findings) named.add(finding);
  for (const auto& entry : suppressed) named.add(entry.finding);
  SourceLines lines(text);
  for (const auto& [number, column] : named.columns()) {
    record.lines.push_back({number, std::string(excerpted_part(lines.line(number), column))});
  }
  return record;
}

std::string MapRecord::quoted_text() const {
  std::string text;
  std::size_t number = 1;
  for (const auto& line : lines) {
    text.append(line.number - number, '\n');
    text += line.text;
    number = line.number;
  }
  return text;
}

MapReport MapRecord::report(std::string_view text) const {
  return {path, text, findings, unreadable, sections, interruption, names, suppressed};
}

}  // namespace mapwright::validators
