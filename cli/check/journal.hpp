// The maps that are done, on disk as each is: a run that is killed can go on.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "validators/report/map_record.hpp"

namespace mapwright::cli {

enum class JournalStart { kNew, kResume };

/// A file of JSON lines, {"settings": fingerprint, "map": record}, that only grows; each line is
/// written at once when its map is done. Lines that a kill tore, or that are of other settings, are
/// passed over. One process at a time.
class Journal {
 public:
  /// Throws Error: kOutput where the file cannot be written or another process has it; kUsage for
  /// kNew where it holds something already.
  Journal(const std::string& path, std::string settings, JournalStart start);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  /// What was said of a map (record path) when its digest was that, with the same settings.
  std::optional<validators::MapRecord> find(const std::string& path,
                                            const std::string& map_digest) const;

  /// Keeps the record of a map that was checked to its end; others are to be tried again.
  void add(const validators::MapRecord& record);

 private:
  void load();
  void write(const std::string& line);

  std::string path_;
  std::string settings_;
  int descriptor_ = -1;
  std::map<std::string, validators::MapRecord> records_;  // by path, the last one
};

}  // namespace mapwright::cli
