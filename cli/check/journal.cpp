#include "cli/check/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;
using validators::MapRecord;

[[noreturn]] void fail_journal(const std::string& path, const std::string& why) {
  throw Error(ExitStatus::kOutput, path + ": " + why);
}

// Unlike flock, a lock of this kind is not passed on to forked workers, who may outlive the run by
// a moment.
bool lock(int descriptor) {
  struct flock request {};
  request.l_type = F_WRLCK;
  request.l_whence = SEEK_SET;
  return ::fcntl(descriptor, F_SETLK, &request) == 0;
}

std::optional<MapRecord> record_in(const std::string& line, const std::string& settings) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("map") || json.value("settings", Json()) != settings) {
    return std::nullopt;
  }
  auto record = validators::parse_record(json["map"].dump());
  return record ? std::optional(*std::move(record)) : std::nullopt;
}

}  // namespace

Journal::Journal(const std::string& path, std::string settings, JournalStart start)
    : path_(path), settings_(std::move(settings)) {
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    fail_journal(path, std::string("cannot be written: ") + std::strerror(errno));
  if (!lock(descriptor_)) {
    ::close(descriptor_);
    fail_journal(path, "is the journal of another run that still goes on");
  }
  if (start == JournalStart::kResume) {
    load();
  } else if (::lseek(descriptor_, 0, SEEK_END) > 0) {
    ::close(descriptor_);
    fail_usage("--journal: " + path +
               " holds something already; --resume goes on with it, or remove it");
  }
}

Journal::~Journal() {
  ::close(descriptor_);
}

// A descriptor of its own for reading would release the lock when closed, so this one reads.
void Journal::load() {
  std::string text;
  std::string buffer(1U << 16U, '\0');
  ssize_t got = 0;
  for (off_t at = 0; (got = ::pread(descriptor_, buffer.data(), buffer.size(), at)) > 0;
       at += got) {
    text.append(buffer, 0, static_cast<std::size_t>(got));
  }
  if (got < 0) fail_journal(path_, std::string("cannot be read: ") + std::strerror(errno));
  std::size_t begin = 0;
  for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', begin)) {
    if (auto record = record_in(text.substr(begin, end - begin), settings_)) {
      const std::string path = record->path;
      records_.insert_or_assign(path, *std::move(record));
    }
    begin = end + 1;
  }
  if (begin < text.size()) write("\n");  // ends the torn line
}

void Journal::write(const std::string& line) {
  std::size_t done = 0;
  while (done < line.size()) {
    const ssize_t written = ::write(descriptor_, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_journal(path_, std::string("cannot be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(written);
  }
}

std::optional<MapRecord> Journal::find(const std::string& path,
                                       const std::string& map_digest) const {
  const auto found = records_.find(path);
  if (found == records_.end() || found->second.digest != map_digest) return std::nullopt;
  return found->second;
}

void Journal::add(const MapRecord& record) {
  if (record.unreadable) return;
  write("{\"settings\":\"" + settings_ + "\",\"map\":" + record_json(record) + "}\n");
}

}  // namespace mapwright::cli
