#include "cli/support/map_files.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/heap.hpp"
#include "cli/support/mapped_file.hpp"
#include "mapcore/text/reader.hpp"

namespace mapwright::cli {

MapText read_map_text(const std::string& path) {
  if (auto text = map_large_file(path)) return *std::move(text);
  return read_file(path);
}

MapDocument read_map_file(const std::string& path) {
  MapText text = read_map_text(path);
  expect_map_of(text.size());
  return read_map(std::move(text));
}

void keep_to_the_end(std::shared_ptr<const void> kept) {
  static auto* const all = new std::vector<std::shared_ptr<const void>>;  // never destroyed
  all->push_back(std::move(kept));
}

Result<std::optional<Georeference>> read_sidecar(const std::string& map_path) {
  const std::string path = sidecar_path(map_path);
  std::error_code error;
  if (map_path == "-" || !std::filesystem::exists(path, error)) return std::nullopt;
  auto georeference = parse_georeference(read_file(path));
  if (!georeference) return tl::unexpected(georeference.error());
  return *std::move(georeference);
}

Georeference moved(Georeference georeference, const std::string& from_map,
                   const std::string& to_map) {
  namespace fs = std::filesystem;
  const fs::path from = fs::path(from_map).parent_path(), to = fs::path(to_map).parent_path();
  if (from == to) return georeference;
  for (auto& source : georeference.sources) {
    const fs::path path(source.path);
    if (source.path.empty() || path.is_absolute()) continue;
    std::error_code error;
    const fs::path there =
        fs::relative(from.empty() ? path : from / path, to.empty() ? fs::path(".") : to, error);
    if (!error && !there.empty()) source.path = there.generic_string();
  }
  return georeference;
}

MapDocument read_sound_map_file(const std::string& path) {
  MapDocument document = read_map_file(path);
  const auto is_error = [](const Finding& finding) { return finding.severity == Severity::kError; };
  const auto& findings = document.findings;
  const auto errors = std::count_if(findings.begin(), findings.end(), is_error);
  if (errors == 0) return document;
  const auto first = std::find_if(findings.begin(), findings.end(), is_error);
  std::string message = finding_line(path, *first);
  if (errors > 1) {
    message += "; and " + std::to_string(errors - 1) + " more: 'mapwright validate' names them";
  }
  throw Error(ExitStatus::kInput, message);
}

}  // namespace mapwright::cli
