#include "cli/convert/source_watch.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace mapwright::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kPause{250};

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// The source itself, what a database keeps beside it, and the other parts of a shapefile. Not the
// database's shared memory, which readers touch too.
bool belongs_to(const fs::path& file, const fs::path& source) {
  const std::string name = file.filename().string();
  if (ends_with(name, "-shm")) return false;
  if (name.rfind(source.filename().string(), 0) == 0) return true;
  return source.extension() == ".shp" && file.stem() == source.stem();
}

fs::path whole(const std::string& path) {
  std::error_code error;
  const auto found = fs::weakly_canonical(path, error);
  return error ? fs::path(path) : found;
}

}  // namespace

SourceWatch::SourceWatch(std::vector<std::string> sources, std::vector<std::string> outputs)
    : sources_(std::move(sources)) {
  for (const auto& output : outputs) outputs_.push_back(whole(output));
  last_ = look();
}

void SourceWatch::add_folder(const fs::path& folder, const fs::path& source, Stamps& stamps) const {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const auto path = whole(entry->path().string());
    if (!source.empty() && !belongs_to(path, source)) continue;
    if (std::find(outputs_.begin(), outputs_.end(), path) != outputs_.end()) continue;
    std::error_code gone;
    const Stamp stamp{entry->file_size(gone), entry->last_write_time(gone)};
    if (!gone) stamps[path.string()] = stamp;
  }
}

SourceWatch::Stamps SourceWatch::look() const {
  Stamps stamps;
  for (const auto& source : sources_) {
    const auto path = whole(source);
    std::error_code error;
    if (fs::is_directory(path, error))
      add_folder(path, {}, stamps);
    else
      add_folder(path.parent_path(), path, stamps);
  }
  return stamps;
}

void SourceWatch::wait_for_change() {
  Stamps now = last_;
  do {
    std::this_thread::sleep_for(kPause);
    now = look();
  } while (now == last_);
  while (true) {
    last_ = std::move(now);
    std::this_thread::sleep_for(kPause);
    now = look();
    if (now == last_) return;
  }
}

}  // namespace mapwright::cli
