#include "cli/support/map_list.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> maps_in(const std::string& folder) {
  std::vector<std::string> maps;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".txt" && !entry.is_directory()) {
      maps.push_back(entry.path().string());
    }
  }
  if (error) throw Error(ExitStatus::kInput, folder + ": cannot be listed: " + error.message());
  if (maps.empty()) throw Error(ExitStatus::kInput, folder + ": holds no map (*.txt)");
  std::sort(maps.begin(), maps.end());
  return maps;
}

}  // namespace

Shard parse_shard(const std::string& option, const std::string& text) {
  const auto slash = text.find('/');
  if (slash == text.npos) {
    fail_usage("--" + option + ": expected part/parts, for example 2/5, got '" + text + "'");
  }
  Shard shard;
  shard.parts = parse_integer(option, text.substr(slash + 1), 1, 1'000'000);
  shard.part = parse_integer(option, text.substr(0, slash), 1, shard.parts);
  return shard;
}

std::vector<std::string> expand_map_paths(const std::vector<std::string>& paths) {
  std::vector<std::string> maps;
  for (const auto& path : paths) {
    std::error_code error;
    if (path == "-" || !fs::is_directory(path, error)) {
      maps.push_back(path);
      continue;
    }
    const auto found = maps_in(path);
    maps.insert(maps.end(), found.begin(), found.end());
  }
  return maps;
}

std::vector<std::string> shard_of(const std::vector<std::string>& paths, const Shard& shard) {
  std::vector<std::string> part;
  for (std::size_t i = shard.part - 1; i < paths.size(); i += shard.parts) part.push_back(paths[i]);
  return part;
}

}  // namespace mapwright::cli
