// Which maps a verb works on, when it takes many.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mapwright::cli {

/// One part of several: `--shard i/n`.
struct Shard {
  std::size_t part = 1;  ///< 1-based
  std::size_t parts = 1;
};

/// "2/5". Throws Error (kUsage).
Shard parse_shard(const std::string& option, const std::string& text);

/// The paths given, with each folder replaced by the files *.txt in it (not in its subfolders), by
/// name. Throws Error (kInput) for a folder that cannot be listed or holds none.
std::vector<std::string> expand_map_paths(const std::vector<std::string>& paths);

/// Every `parts`-th path from number `part` on: together the shards are all paths, each once.
std::vector<std::string> shard_of(const std::vector<std::string>& paths, const Shard& shard);

}  // namespace mapwright::cli
