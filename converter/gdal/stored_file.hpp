// Bytes of a file, on disk or in an archive that GDAL has unpacked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace mapwright::converter {

/// Size of a regular file; nothing where there is none.
std::optional<std::uint64_t> stored_bytes(const std::string& path);

/// All bytes of a file; nothing where they cannot be read.
std::optional<std::string> stored_content(const std::string& path);

/// A file open for reading; one that cannot be opened has no bytes.
class StoredFile {
 public:
  explicit StoredFile(const std::string& path);

  /// Reads up to `size` bytes from an offset; returns how many there were.
  std::size_t read(std::uint64_t offset, void* bytes, std::size_t size) const;

 private:
  std::shared_ptr<void> handle_;
};

}  // namespace mapwright::converter
