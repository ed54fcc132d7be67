#include "converter/gdal/shapefile_check.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kHeaderBytes = 100;  // of .shp and .shx (ESRI white paper, 1998)
constexpr std::uint32_t kFileCode = 9994;
constexpr std::uint64_t kDbfHeaderBytes = 32;

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The file beside `shp` with that extension, in upper or lower case.
std::optional<fs::path> sibling(const fs::path& shp, const std::string& extension) {
  for (auto name : {extension, std::string()}) {
    if (name.empty()) {
      name = extension;
      for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    fs::path path = shp;
    path.replace_extension(name);
    if (stored_bytes(path.string())) return path;
  }
  return std::nullopt;
}

template <std::size_t N>
std::optional<std::array<unsigned char, N>> first_bytes(const fs::path& path) {
  std::array<unsigned char, N> bytes{};
  const StoredFile file(path.string());
  if (file.read(0, bytes.data(), N) != N) return std::nullopt;
  return bytes;
}

std::uint32_t big_endian(const unsigned char* bytes) {
  return (static_cast<std::uint32_t>(bytes[0]) << 24U) |
         (static_cast<std::uint32_t>(bytes[1]) << 16U) |
         (static_cast<std::uint32_t>(bytes[2]) << 8U) | bytes[3];
}

std::uint32_t little_endian(const unsigned char* bytes) {
  return (static_cast<std::uint32_t>(bytes[3]) << 24U) |
         (static_cast<std::uint32_t>(bytes[2]) << 16U) |
         (static_cast<std::uint32_t>(bytes[1]) << 8U) | bytes[0];
}

std::uint64_t size_of(const fs::path& path) {
  return stored_bytes(path.string()).value_or(0);
}

// Checks the common header of .shp and .shx, and that the file is as long as it says.
Result<std::uint64_t> declared_bytes(const fs::path& path, const std::string& title) {
  if (!stored_bytes(path.string())) {
    return input_failure(title + ": this part of the shapefile is missing; it holds the shapes");
  }
  const auto header = first_bytes<kHeaderBytes>(path);
  if (!header) {
    return input_failure(title + ": " + (size_of(path) == 0 ? "is empty" : "is cut short") +
                         ": a shapefile's header has 100 bytes");
  }
  if (big_endian(header->data()) != kFileCode) {
    return input_failure(title + ": is no shapefile: its first bytes are not 9994");
  }
  const std::uint64_t bytes = 2ULL * big_endian(header->data() + 24);
  if (size_of(path) < bytes) {
    return input_failure(title + ": is cut short: its header says " + std::to_string(bytes) +
                         " bytes, the file has " + std::to_string(size_of(path)) +
                         "; get a complete copy");
  }
  return bytes;
}

// An index holds nothing that the shapes do not say.
Result<std::uint64_t> indexed_shapes(const fs::path& shx, const std::string& title) {
  const auto bytes = declared_bytes(shx, title);
  if (!bytes) {
    return input_failure(bytes.error().message +
                         ", or take this index away: it is made anew where there is none");
  }
  return (*bytes - std::min(*bytes, kHeaderBytes)) / 8;
}

struct DbfSize {
  std::uint64_t records = 0;
  bool names_encoding = false;
};

Result<DbfSize> dbf_size(const fs::path& path, const std::string& title) {
  const auto header = first_bytes<kDbfHeaderBytes>(path);
  if (!header) return input_failure(title + ": is cut short: no complete header");
  const std::uint64_t records = little_endian(header->data() + 4);
  const std::uint64_t header_bytes = (*header)[8] + 256ULL * (*header)[9];
  const std::uint64_t record_bytes = (*header)[10] + 256ULL * (*header)[11];
  const std::uint64_t needed = header_bytes + records * record_bytes;
  if (size_of(path) < needed) {
    return input_failure(title + ": is cut short: " + std::to_string(records) + " records need " +
                         std::to_string(needed) + " bytes, the file has " +
                         std::to_string(size_of(path)) + "; get a complete copy");
  }
  return DbfSize{records, (*header)[29] != 0};
}

// What people call a part: beside the .shp that they know.
std::string part_title(const std::string& shp_title, const fs::path& part) {
  return fs::path(shp_title).replace_filename(part.filename()).string();
}

std::vector<std::string> encoding_warnings(const fs::path& shp, const std::string& title,
                                           bool dbf_names_encoding) {
  if (dbf_names_encoding || sibling(shp, ".cpg")) return {};
  return {
      title +
      ": no .cpg file says how its texts are encoded: read as ISO-8859-1 where they are not UTF-8"};
}

ShapefileRemarks without_table(const std::string& title) {
  return {{title + ": its .dbf file is missing: it is read as shapes without attributes"}, true};
}

}  // namespace

Result<void> check_shapes(const fs::path& shp, const std::string& title) {
  const auto bytes = declared_bytes(shp, title);
  return bytes ? Result<void>() : tl::unexpected(bytes.error());
}

// An entry has the record's offset and the length of its content, both in words of two bytes; the
// record has a header of four such words before its content.
bool index_is_complete(const fs::path& shp) {
  const auto shx = sibling(shp, ".shx");
  const auto bytes = declared_bytes(shp, shp.string());
  if (!shx || !bytes || size_of(*shx) < kHeaderBytes) return false;
  if (size_of(*shx) == kHeaderBytes) return *bytes == kHeaderBytes;
  std::array<unsigned char, 8> entry{};
  const auto at = size_of(*shx) - entry.size();
  if (StoredFile(shx->string()).read(at, entry.data(), entry.size()) != entry.size()) return false;
  return 2ULL * (big_endian(entry.data()) + big_endian(entry.data() + 4) + 4ULL) == *bytes;
}

bool lacks_index(const fs::path& shp) {
  return stored_bytes(shp.string()) && !sibling(shp, ".shx");
}

Result<ShapefileRemarks> check_shapefile(const fs::path& shp, const std::string& title) {
  if (auto checked = check_shapes(shp, title); !checked) return tl::unexpected(checked.error());
  const auto shx = sibling(shp, ".shx");
  if (!shx) return input_failure(title + ": its .shx file is missing; put it beside the .shp");
  const auto shapes = indexed_shapes(*shx, part_title(title, *shx));
  if (!shapes) return tl::unexpected(shapes.error());
  const auto dbf = sibling(shp, ".dbf");
  if (!dbf) return without_table(title);
  const auto table = dbf_size(*dbf, part_title(title, *dbf));
  if (!table) return tl::unexpected(table.error());
  if (*shapes != table->records) {
    return input_failure(title + ": it has " + std::to_string(*shapes) +
                         " shapes by its index, and its .dbf " + std::to_string(table->records) +
                         " records: the parts do not belong together; get a complete copy");
  }
  return ShapefileRemarks{encoding_warnings(shp, title, table->names_encoding), false};
}

std::vector<fs::path> shapefiles_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    const std::string extension = lower_case(path.extension().string());
    if (extension == ".shp") return {path};
    if (extension != ".dbf" && extension != ".shx") return {};
    const auto shp = sibling(path, ".shp");
    return {shp ? *shp : fs::path(path).replace_extension(".shp")};
  }
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    if (lower_case(entry.path().extension().string()) == ".shp") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace mapwright::converter
