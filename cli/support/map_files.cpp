#include "cli/support/map_files.hpp"

#include <filesystem>

#include "cli/support/files.hpp"
#include "mapcore/text/reader.hpp"

namespace mapwright::cli {

MapDocument read_map_file(const std::string& path) {
  return read_map(read_file(path));
}

Result<std::optional<Georeference>> read_sidecar(const std::string& map_path) {
  const std::string path = sidecar_path(map_path);
  std::error_code error;
  if (map_path == "-" || !std::filesystem::exists(path, error)) return std::nullopt;
  auto georeference = parse_georeference(read_file(path));
  if (!georeference) return tl::unexpected(georeference.error());
  return *std::move(georeference);
}

}  // namespace mapwright::cli
