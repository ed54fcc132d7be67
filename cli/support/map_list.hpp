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

/// A map to work on.
struct MapInput {
  std::string path;  ///< to open it; "-" is standard input
  std::string key;   ///< where it is within the folder that was named; shards go by it
};

enum class Subfolders : bool { kSkip, kEnter };

/// The paths given, with each folder replaced by the files *.txt in it and, if asked, in its
/// subfolders; by path, each file once. Names that begin with a dot are passed over in folders.
/// Throws Error: kInput for a folder that cannot be listed, kUsage for one that holds no map.
std::vector<MapInput> expand_map_paths(const std::vector<std::string>& paths,
                                       Subfolders subfolders = Subfolders::kSkip);

/// The maps of a shard, in the order given. Which shard a map belongs to depends on its key and the
/// number of shards alone: a map that comes or goes moves no other.
std::vector<MapInput> shard_of(const std::vector<MapInput>& maps, const Shard& shard);

}  // namespace mapwright::cli
