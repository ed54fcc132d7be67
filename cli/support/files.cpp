#include "cli/support/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_input(const std::string& path, const std::string& why) {
  throw Error(ExitStatus::kInput, path + ": " + why);
}

[[noreturn]] void fail_output(const std::string& path, const std::string& why) {
  throw Error(ExitStatus::kOutput, path + ": " + why);
}

std::string system_reason() {
  return std::strerror(errno);
}

// Names of the temporary files that exist now, where a signal handler can read them: plain
// characters, no allocation. More than this many are open at no time.
constexpr std::size_t kSlots = 16;
constexpr std::size_t kPathBytes = 4096;
struct Slot {
  std::atomic<bool> used{false};
  std::array<char, kPathBytes> path{};
};
std::array<Slot, kSlots> open_temporaries;

void remember(const std::string& path) {
  if (path.size() >= kPathBytes) return;
  for (auto& slot : open_temporaries) {
    if (slot.used.load()) continue;
    std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
    slot.used.store(true);
    return;
  }
}

void forget(const std::string& path) {
  for (auto& slot : open_temporaries) {
    if (slot.used.load() && path == slot.path.data()) slot.used.store(false);
  }
}

// One entry of a folder as the kernel hands it out (getdents64(2)).
struct FolderEntry {
  std::uint64_t inode;
  std::int64_t offset;
  unsigned short length;
  unsigned char type;
  char name[1];
};

// Empties and removes a folder that holds files only. Allocates nothing, as a signal handler must:
// opendir(3) does.
void remove_folder(const char* path) {
  const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  alignas(FolderEntry) std::array<char, 4096> buffer;
  while (true) {
    const long bytes = ::syscall(SYS_getdents64, folder, buffer.data(), buffer.size());
    if (bytes <= 0) break;
    for (long at = 0; at < bytes;) {
      const auto* entry = reinterpret_cast<const FolderEntry*>(buffer.data() + at);
      ::unlinkat(folder, static_cast<const char*>(entry->name), 0);
      at += entry->length;
    }
  }
  ::close(folder);
  ::rmdir(path);
}

void remove_temporary(const char* path) {
  if (::unlink(path) != 0 && (errno == EISDIR || errno == EPERM)) remove_folder(path);
}

extern "C" void on_interrupt(int signal) {
  remove_temporary_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// The file a link names: renaming onto the link itself would put a file in its place.
std::string through_links(std::string target) {
  std::error_code error;
  if (!fs::is_symlink(target, error)) return target;
  const fs::path file = fs::weakly_canonical(target, error);
  return error ? target : file.string();
}

// Devices and pipes (/dev/null, /dev/stdout, <(...)) are written to; a rename would replace them.
bool is_device(const std::string& target) {
  std::error_code error;
  const auto type = fs::status(target, error).type();
  return type == fs::file_type::character || type == fs::file_type::block ||
         type == fs::file_type::fifo || type == fs::file_type::socket;
}

// A fresh name beside the target, created empty so that nobody else takes it.
std::string create_temporary_beside(const std::string& target) {
  const fs::path path(target);
  const std::string extension = path.extension().string();
  std::string pattern = (path.parent_path() / ("." + path.stem().string() + ".XXXXXX")).string();
  pattern += extension;
  const int descriptor = ::mkstemps(pattern.data(), static_cast<int>(extension.size()));
  if (descriptor < 0) fail_output(target, "cannot be written: " + system_reason());
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666U & ~mask);
  ::close(descriptor);
  return pattern;
}

}  // namespace

void remove_temporary_files() {
  for (auto& slot : open_temporaries) {
    if (slot.used.load()) remove_temporary(slot.path.data());
  }
}

void remove_temporary_files_on_interrupt() {
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM}) std::signal(signal, on_interrupt);
  // nohup means it, and who ignores closed pipes wants to be told of failed writes instead.
  for (const int signal : {SIGHUP, SIGPIPE}) {
    if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

std::string read_file(const std::string& path) {
  if (path == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::error_code error;
  if (fs::is_directory(path, error)) fail_input(path, "is a folder, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_input(path, "cannot be read: " + system_reason());
  std::string text;
  const auto size = fs::file_size(path, error);
  if (!error) text.reserve(size);
  std::array<char, 1U << 16U> buffer;
  while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) fail_input(path, "cannot be read to its end: " + system_reason());
  return text;
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") {
    write(std::cout);
    if (!std::cout.flush()) fail_output("standard output", "cannot be written");
    return;
  }
  TemporaryFile temporary(path);
  std::ofstream out(temporary.path(), std::ios::binary);
  write(out);
  out.close();
  if (!out) fail_output(path, "cannot be written: " + system_reason());
  temporary.commit();
}

TemporaryFolder::TemporaryFolder(const std::string& target) : target_(through_links(target)) {
  const fs::path path(target_);
  std::error_code error;
  if (!path.parent_path().empty() && !fs::is_directory(path.parent_path(), error)) {
    fail_output(target, "cannot be written: there is no folder " + path.parent_path().string());
  }
  std::string pattern = (path.parent_path() / ("." + path.stem().string() + ".XXXXXX")).string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    fail_output(target, "cannot be written: " + system_reason());
  }
  path_ = pattern;
  remember(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
  forget(path_);
}

void TemporaryFolder::commit(const std::vector<std::string>& names) {
  const fs::path folder = fs::path(target_).parent_path();
  std::error_code error;
  for (const auto& name : names) {
    if (fs::is_directory(folder / name, error)) {
      fail_output((folder / name).string(), "is a folder, not a file");
    }
  }
  for (const auto& name : names) {
    const std::string to = (folder / name).string();
    if (::rename((fs::path(path_) / name).c_str(), to.c_str()) != 0) {
      fail_output(to, "cannot be written: " + system_reason());
    }
  }
}

TemporaryFile::TemporaryFile(std::string target) : target_(through_links(std::move(target))) {
  std::error_code error;
  if (fs::is_directory(target_, error)) fail_output(target_, "is a folder, not a file");
  if (is_device(target_)) {
    path_ = target_;
    return;
  }
  const fs::path folder = fs::path(target_).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    fail_output(target_, "cannot be written: there is no folder " + folder.string());
  }
  path_ = create_temporary_beside(target_);
  remember(path_);
}

TemporaryFile::~TemporaryFile() {
  if (path_ == target_) return;
  if (!committed_) ::unlink(path_.c_str());
  forget(path_);
}

void TemporaryFile::commit() {
  if (path_ == target_) return;
  if (::rename(path_.c_str(), target_.c_str()) != 0) {
    fail_output(target_, "cannot be written: " + system_reason());
  }
  committed_ = true;
}

}  // namespace mapwright::cli
