// Every GIS file of a folder through `mapwright convert`: what came of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mapwright::test {

/// One run of the program on one file.
struct SurveyRow {
  std::string file;     ///< from the folder of the data
  std::string options;  ///< beyond the file and the output: "--local" where it states no CRS
  int status = 0;       ///< exit status, or 128 + the signal that ended it
  bool hung = false;
  double seconds = 0.0;     ///< of processor time, in all its processes
  bool doubts_crs = false;  ///< a warning says that the stated CRS is hard to believe
  bool has_ledger = false;
  std::size_t features = 0, written = 0, changed = 0, dropped = 0;
  std::map<std::string, std::size_t> codes;  ///< reasons of the ledger, by code
  bool loses = false;                        ///< the ledger has reasons of severity error
  std::string message;  ///< first line of standard error that says what is wrong
};

/// Files of GIS formats in a folder, sorted; of a shapefile the .shp alone. Also formats that are
/// to be refused. Paths are relative to `root`.
std::vector<std::filesystem::path> vector_files(const std::filesystem::path& root,
                                                const std::string& folder);

/// Converts a file; where it states no CRS, once more with --local. `limit_s` ends a run.
std::vector<SurveyRow> survey_file(const std::string& program, const std::filesystem::path& root,
                                   const std::filesystem::path& file, double limit_s);

}  // namespace mapwright::test
