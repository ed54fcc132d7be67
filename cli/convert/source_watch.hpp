// Notices when sources are saved.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mapwright::cli {

/// Looks at the files of sources a few times a second. Polling, because it works on network drives,
/// and because editors save by renaming, through journals and in several parts.
class SourceWatch {
 public:
  /// `sources`: files or folders; of folders the files directly within. `outputs` are never
  /// sources, wherever they lie.
  SourceWatch(std::vector<std::string> sources, std::vector<std::string> outputs);

  /// Comes back when something has changed since the last call (the first time: since construction)
  /// and then stood still, so that nothing half saved is read.
  void wait_for_change();

 private:
  struct Stamp {
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type changed;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  using Stamps = std::map<std::string, Stamp>;

  Stamps look() const;
  void add_folder(const std::filesystem::path& folder, const std::filesystem::path& source,
                  Stamps& stamps) const;

  std::vector<std::string> sources_;
  std::vector<std::filesystem::path> outputs_;
  Stamps last_;
};

}  // namespace mapwright::cli
