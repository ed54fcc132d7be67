#include "converter/gdal/tab_check.hpp"

#include <cpl_string.h>

#include <cctype>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kHeaderBytes = 1U << 12U;

// Tables of pictures and of other programs' files have other parts.
bool has_parts(const std::string& path) {
  std::string header(kHeaderBytes, '\0');
  header.resize(StoredFile(path).read(0, header.data(), header.size()));
  for (char& c : header) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return header.find("type native") != header.npos;
}

bool is_beside(std::filesystem::path path, const std::string& extension) {
  for (const bool upper : {false, true}) {
    std::string spelled = extension;
    for (char& c : spelled) c = static_cast<char>(upper ? std::toupper(c) : c);
    if (stored_bytes(path.replace_extension(spelled).string())) return true;
  }
  return false;
}

std::string missing(std::filesystem::path path, const std::string& extension,
                    const std::string& content) {
  const auto table = path.filename().string();
  const auto part = path.replace_extension(extension).filename().string();
  return part + " is missing, which holds its " + content + ": put it beside " + table;
}

}  // namespace

std::optional<std::string> missing_beside_tab(const std::filesystem::path& path) {
  if (!EQUAL(path.extension().c_str(), ".tab") || !has_parts(path.string())) return std::nullopt;
  if (!is_beside(path, ".map")) {
    return missing(path, ".map", "shapes and coordinate reference system");
  }
  if (!is_beside(path, ".dat")) return missing(path, ".dat", "heights, types and names");
  if (!is_beside(path, ".id")) return missing(path, ".id", "order of shapes");
  return std::nullopt;
}

}  // namespace mapwright::converter
