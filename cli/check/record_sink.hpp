// Where records of checked maps go: a report for people or programs, or a part of one.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "validators/report/map_record.hpp"
#include "validators/report/report.hpp"

namespace mapwright::cli {

class RecordSink {
 public:
  virtual ~RecordSink() = default;
  /// Maps come in the order of their paths.
  virtual void add(const validators::MapRecord& record) = 0;
  /// Behind the maps: what is wrong with a configuration file. Parts leave that to the whole.
  virtual void add_configuration(const validators::MapReport& report) = 0;
  /// Call once behind all that.
  virtual void finish() = 0;
};

/// A report of schema mapwright.check/1. In text, many maps get a table at the end. Formats that
/// draw maps read them again: `add` throws Error (kInput) for a map that is not there as it was
/// checked. `standard_input` is the text of the map "-".
std::unique_ptr<RecordSink> make_report_sink(const validators::ReportFormat& format,
                                             std::ostream& out, bool colour,
                                             std::optional<std::string> standard_input = {});

}  // namespace mapwright::cli
