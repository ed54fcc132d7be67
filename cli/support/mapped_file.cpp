#include "cli/support/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <memory>
#include <string_view>

#include "cli/support/files.hpp"
#include "cli/verb.hpp"

namespace mapwright::cli {
namespace {

// Reading a smaller file costs less than asking for pages.
constexpr std::size_t kLargeBytes = std::size_t{1} << 20U;

std::size_t page_bytes() {
  return static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  int number() const { return number_; }

  // 0 for what is no regular file.
  std::size_t size() const {
    struct stat status {};
    if (number_ < 0 || ::fstat(number_, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    return static_cast<std::size_t>(status.st_size);
  }

 private:
  int number_;
};

// Whole pages that lie before an end are given back; they come again from the file when needed.
class Mapping : public TextKeeper {
 public:
  Mapping(char* bytes, std::size_t reserved) : bytes_(bytes), reserved_(reserved) {}
  ~Mapping() override { ::munmap(bytes_, reserved_); }

  void release(std::size_t /*begin*/, std::size_t end) override {
    // Few calls, each over pages enough to be worth it.
    constexpr std::size_t kWorthwhile = std::size_t{1} << 22U;
    if (end < released_ + kWorthwhile) return;
    const std::size_t pages_end = end / page_bytes() * page_bytes();
    ::madvise(bytes_ + released_, pages_end - released_, MADV_DONTNEED);
    released_ = pages_end;
  }

 private:
  char* bytes_;
  std::size_t reserved_;
  std::size_t released_ = 0;
};

// The bytes of the file, and zeros behind them up to the end of a page; null where that fails.
char* mapped(const Descriptor& file, std::size_t size, std::size_t reserved) {
  void* const room =
      ::mmap(nullptr, reserved, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) return nullptr;
  if (::mmap(room, size, PROT_READ, MAP_PRIVATE | MAP_FIXED, file.number(), 0) == MAP_FAILED) {
    ::munmap(room, reserved);
    return nullptr;
  }
  ::madvise(room, size, MADV_SEQUENTIAL);
  return static_cast<char*>(room);
}

extern "C" void on_cut_file(int /*signal*/) {
  constexpr std::string_view kMessage =
      "mapwright: error: a file became shorter while it was read; try again\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  remove_temporary_files();
  ::_exit(static_cast<int>(ExitStatus::kInput));
}

}  // namespace

std::optional<MapText> map_large_file(const std::string& path) {
  const Descriptor file(path);
  const std::size_t size = file.size();
  if (size < kLargeBytes) return std::nullopt;
  const std::size_t reserved = (size / page_bytes() + 1) * page_bytes();
  char* const bytes = mapped(file, size, reserved);
  if (bytes == nullptr) return std::nullopt;
  std::signal(SIGBUS, on_cut_file);
  return MapText({bytes, size}, std::make_shared<Mapping>(bytes, reserved));
}

}  // namespace mapwright::cli
