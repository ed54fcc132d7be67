// What `mapwright convert` leaves behind.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/support/console.hpp"
#include "cli/support/files.hpp"
#include "converter/pipeline/convert.hpp"
#include "mapcore/finding.hpp"

namespace mapwright::cli {

/// Map, sidecar and report under temporary names, until all are complete.
class ConvertedFiles {
 public:
  /// Takes the names; throws Error (kOutput) where a file cannot be written. `report` may be empty,
  /// one of the two "-": standard output.
  ConvertedFiles(const std::string& output, const std::string& report);

  /// Writes the map, reads the file back and returns what validation finds in it. `is_last`: the
  /// process ends soon.
  std::vector<Finding> write_map(converter::ConvertedMap map, double resolution_m, Console& console,
                                 bool is_last = true);
  std::vector<Finding> write_map(Map map, double resolution_m, Console& console);
  void write_sidecar(const std::optional<Georeference>& georeference);
  /// Writes the report and gives it its name: what became of features is told also where no map is
  /// written.
  void write_report(const converter::Ledger& ledger, Console& console);

  /// Gives map and sidecar their names.
  void commit_map();

 private:
  std::string output_, report_name_;
  std::unique_ptr<TemporaryFile> map_, sidecar_, report_;
};

}  // namespace mapwright::cli
