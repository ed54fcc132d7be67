#include "converter/gdal/mif_check.hpp"

#include <cpl_string.h>

#include <cctype>
#include <cstdlib>
#include <string>
#include <string_view>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kHeaderBytes = 1U << 16U;
constexpr std::string_view kColumns = "\ncolumns ";

// The number that the header's line "Columns n" states.
long columns_of(const std::string& path) {
  std::string header(kHeaderBytes, '\0');
  header.resize(StoredFile(path).read(0, header.data(), header.size()));
  for (char& c : header) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto at = header.find(kColumns);
  return at == header.npos ? 0 : std::strtol(header.c_str() + at + kColumns.size(), nullptr, 10);
}

}  // namespace

bool mif_lacks_values(const std::filesystem::path& path) {
  if (!EQUAL(path.extension().c_str(), ".mif")) return false;
  for (const char* extension : {".mid", ".MID", ".Mid"}) {
    if (stored_bytes(std::filesystem::path(path).replace_extension(extension).string())) {
      return false;
    }
  }
  return columns_of(path.string()) > 0;
}

}  // namespace mapwright::converter
