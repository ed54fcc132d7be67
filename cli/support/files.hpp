// Whole files in and out, by the rules of docs/cli.md.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace mapwright::cli {

/// The whole of a file, or of standard input for "-". Throws Error (kInput) that says why not.
std::string read_file(const std::string& path);

/// Writes through a temporary file beside `path` that is renamed when complete, so that the target
/// is either the old file or the whole new one; a link's file is renamed to, not the link; devices
/// and pipes are written to as they are; "-" is standard output. Throws Error (kOutput).
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

/// A file that another library writes under a temporary name; `commit` renames it to the target.
/// Removed when not committed, also on SIGINT and SIGTERM.
class TemporaryFile {
 public:
  /// The temporary name keeps the target's extension, which libraries choose formats by.
  explicit TemporaryFile(std::string target);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  const std::string& path() const { return path_; }
  void commit();

 private:
  std::string target_;
  std::string path_;
  bool committed_ = false;
};

/// A folder beside a target in which another library writes files of a set. Each gets its place
/// beside the target when committed; whatever is left is removed, also on SIGINT and SIGTERM.
class TemporaryFolder {
 public:
  /// Throws Error (kOutput) where no folder can be made beside `target`.
  explicit TemporaryFolder(const std::string& target);
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::string& path() const { return path_; }

  /// Renames files of these names to the target's folder, one after the other. Throws Error
  /// (kOutput) before the first where one cannot stand there.
  void commit(const std::vector<std::string>& names);

 private:
  std::string target_;
  std::string path_;
};

/// Removes temporary files when the program is interrupted, or nobody reads its standard output.
void remove_temporary_files_on_interrupt();

/// Removes all temporary files there are now. A signal handler may call it.
void remove_temporary_files();

}  // namespace mapwright::cli
