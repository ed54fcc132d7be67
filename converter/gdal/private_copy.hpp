// Copies of sources that could not be read where they are without leaving traces.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// A folder of this process's own that vanishes with the object.
class PrivateFolder {
 public:
  static Result<std::unique_ptr<PrivateFolder>> create();
  explicit PrivateFolder(std::filesystem::path path) : path_(std::move(path)) {}
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// True for a SQLite database with a write-ahead log or a journal: SQLite would write files beside
/// it even to read it.
bool reading_leaves_traces(const std::filesystem::path& database);

/// Copies the database with its log and journal into `folder`; returns the copy's path.
Result<std::filesystem::path> copy_database(const std::filesystem::path& database,
                                            const std::filesystem::path& folder);

}  // namespace mapwright::converter
