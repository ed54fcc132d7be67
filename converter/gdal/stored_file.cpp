#include "converter/gdal/stored_file.hpp"

#include <cpl_vsi.h>

namespace mapwright::converter {

std::optional<std::uint64_t> stored_bytes(const std::string& path) {
  VSIStatBufL stat{};
  if (VSIStatL(path.c_str(), &stat) != 0 || VSI_ISDIR(stat.st_mode) != 0) return std::nullopt;
  return static_cast<std::uint64_t>(stat.st_size);
}

StoredFile::StoredFile(const std::string& path) {
  if (auto* file = VSIFOpenL(path.c_str(), "rb")) {
    handle_ =
        std::shared_ptr<void>(file, [](void* open) { VSIFCloseL(static_cast<VSILFILE*>(open)); });
  }
}

std::size_t StoredFile::read(std::uint64_t offset, void* bytes, std::size_t size) const {
  auto* file = static_cast<VSILFILE*>(handle_.get());
  if (file == nullptr || VSIFSeekL(file, offset, SEEK_SET) != 0) return 0;
  return VSIFReadL(bytes, 1, size, file);
}

std::optional<std::string> stored_content(const std::string& path) {
  const auto bytes = stored_bytes(path);
  if (!bytes) return std::nullopt;
  std::string content(*bytes, '\0');
  if (StoredFile(path).read(0, content.data(), content.size()) != content.size()) {
    return std::nullopt;
  }
  return content;
}

}  // namespace mapwright::converter
