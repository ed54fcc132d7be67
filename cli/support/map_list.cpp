#include "cli/support/map_list.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "cli/support/arguments.hpp"
#include "cli/support/digest.hpp"
#include "cli/support/error.hpp"
#include "cli/support/findings_text.hpp"

namespace mapwright::cli {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

[[noreturn]] void fail_to_list(const std::string& folder, const std::error_code& error) {
  throw Error(ExitStatus::kInput, folder + ": cannot be listed: " + error.message());
}

// Links to folders are not followed: they may lead in circles.
void collect_maps(const std::string& top, const fs::path& folder, Subfolders subfolders,
                  std::vector<MapInput>& maps) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    if (is_hidden(path)) continue;
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      const bool enter = subfolders == Subfolders::kEnter && !entry->is_symlink(ignored);
      if (enter) collect_maps(top, path, subfolders, maps);
    } else if (path.extension() == ".txt") {
      maps.push_back({path.string(), path.lexically_relative(top).generic_string()});
    }
  }
  if (error) fail_to_list(folder.string(), error);
}

void add_folder(const std::string& folder, Subfolders subfolders, std::vector<MapInput>& maps) {
  const std::size_t before = maps.size();
  collect_maps(folder, folder, subfolders, maps);
  if (maps.size() > before) return;
  fail_usage(
      folder + ": holds no map (*.txt)" +
      (subfolders == Subfolders::kSkip ? "; --recursive looks into its subfolders too" : ""));
}

// The same for all ways to write a path.
std::string identity(const std::string& path) {
  if (path == "-") return path;
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return (error ? fs::path(path) : absolute).lexically_normal().string();
}

// Each file once, under the shortest of the names that were given for it.
std::vector<MapInput> by_path(std::vector<MapInput> maps) {
  std::map<std::string, MapInput> files;
  for (auto& map : maps) {
    MapInput& known = files[identity(map.path)];
    if (known.path.empty() || map.path.size() < known.path.size()) known = std::move(map);
  }
  std::vector<MapInput> sorted;
  for (auto& [file, map] : files) sorted.push_back(std::move(map));
  std::stable_sort(sorted.begin(), sorted.end(), [](const MapInput& a, const MapInput& b) {
    return display_path(a.path) < display_path(b.path);
  });
  return sorted;
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

std::vector<MapInput> expand_map_paths(const std::vector<std::string>& paths,
                                       Subfolders subfolders) {
  std::vector<MapInput> maps;
  for (const auto& path : paths) {
    std::error_code error;
    if (path != "-" && fs::is_directory(path, error)) {
      add_folder(path, subfolders, maps);
    } else {
      maps.push_back({path, fs::path(path).lexically_normal().generic_string()});
    }
  }
  return by_path(std::move(maps));
}

std::vector<MapInput> shard_of(const std::vector<MapInput>& maps, const Shard& shard) {
  std::vector<MapInput> part;
  for (const auto& map : maps) {
    if (hash64(map.key) % shard.parts == shard.part - 1) part.push_back(map);
  }
  return part;
}

}  // namespace mapwright::cli
