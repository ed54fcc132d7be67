#include "converter/gdal/private_copy.hpp"

#include <stdlib.h>

#include <array>
#include <cstring>
#include <fstream>

namespace mapwright::converter {

namespace fs = std::filesystem;

Result<std::unique_ptr<PrivateFolder>> PrivateFolder::create() {
  std::string pattern = (fs::temp_directory_path() / "mapwright.XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    return output_failure(pattern + ": no folder for temporary files can be made there");
  }
  return std::make_unique<PrivateFolder>(pattern);
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

// Bytes 18 and 19 of the header are 2 in write-ahead mode (SQLite file format, section 1.3).
bool reading_leaves_traces(const fs::path& database) {
  std::array<char, 20> header{};
  std::ifstream in(database, std::ios::binary);
  if (!in.read(header.data(), header.size())) return false;
  if (std::memcmp(header.data(), "SQLite format 3", 16) != 0) return false;
  std::error_code error;
  return header[18] == 2 || header[19] == 2 || fs::exists(database.string() + "-journal", error) ||
         fs::exists(database.string() + "-wal", error);
}

Result<fs::path> copy_database(const fs::path& database, const fs::path& folder) {
  const fs::path copy = folder / database.filename();
  for (const char* suffix : {"", "-wal", "-journal"}) {
    const fs::path from = database.string() + suffix;
    std::error_code error;
    if (!fs::exists(from, error)) continue;
    fs::copy_file(from, copy.string() + suffix, error);
    if (error) {
      return input_failure(from.string() +
                           ": cannot be copied to a temporary folder: " + error.message());
    }
    fs::permissions(copy.string() + suffix, fs::perms::owner_read | fs::perms::owner_write, error);
  }
  return copy;
}

}  // namespace mapwright::converter
