#include "converter/gdal/archive.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>

#include "converter/gdal/messages.hpp"
#include "converter/gdal/single_source.hpp"
#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;
constexpr std::size_t kMostFiles = 10000;
constexpr const char* kUnpackedRoot = "/vsimem/unpacked/";

// The virtual folder in which GDAL shows the archive's files; empty for what is no archive.
std::string mounted(const std::string& path) {
  const StoredFile file(path);
  std::array<char, 262> bytes{};
  const auto size = file.read(0, bytes.data(), bytes.size());
  const std::string_view start(bytes.data(), size);
  if (start.starts_with("PK\3\4") || start.starts_with("PK\5\6")) return "/vsizip/{" + path + "}";
  if (start.starts_with("\x1f\x8b")) {
    const bool tar = path.ends_with(".tar.gz") || path.ends_with(".tgz");
    return tar ? "/vsitar/{" + path + "}" : "/vsigzip/" + path;
  }
  const bool tar = size > 261 && start.substr(257, 5) == "ustar";
  return tar ? "/vsitar/{" + path + "}" : std::string();
}

std::string lower_extension(const std::string& name) {
  std::string extension = fs::path(name).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

bool is_dataset(const std::string& name) {
  static const std::vector<std::string> kExtensions{
      ".shp", ".gpkg", ".geojson", ".json", ".fgb",    ".kml",      ".gml", ".dxf",
      ".csv", ".tab",  ".mif",     ".xml",  ".sqlite", ".topojson", ".osm", ".pbf"};
  return contains(kExtensions, lower_extension(name)) || name.ends_with(".osm.gz") ||
         name.ends_with(".osm.bz2");
}

// What belongs to a data set beside it.
bool is_companion(const std::string& name) {
  static const std::vector<std::string> kExtensions{".shx", ".dbf", ".prj", ".cpg", ".qix", ".sbn",
                                                    ".sbx", ".idm", ".ind", ".idx", ".qmd", ".qpj",
                                                    ".xsd", ".dat", ".id",  ".map", ".mid", ".gfs"};
  return contains(kExtensions, lower_extension(name));
}

// What systems leave in archives beside the files: resource forks of macOS have the files' own
// names.
bool is_litter(const std::string& name) {
  const fs::path path(name);
  const std::string file = path.filename().string();
  return std::find(path.begin(), path.end(), "__MACOSX") != path.end() || file.starts_with("._") ||
         file == ".DS_Store" || file == "Thumbs.db";
}

struct Member {
  std::string name;
  std::uint64_t bytes = 0;
};

bool leaves_the_archive(const std::string& name) {
  const fs::path path(name);
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

// A file's name in the archive of a single gzipped file.
std::string unzipped_name(const std::string& path) {
  return fs::path(path).stem().string();
}

class Archive {
 public:
  explicit Archive(std::string path) : path_(std::move(path)), mount_(mounted(path_)) {}

  Result<std::vector<Member>> members() const {
    const GdalMessages messages;
    std::vector<Member> members;
    if (is_single_file()) {
      members.push_back({unzipped_name(path_), stored_bytes(mount_).value_or(0)});
    } else {
      const CPLStringList names(VSIReadDirRecursive(mount_.c_str()));
      for (int i = 0; i < names.size() && members.size() <= kMostFiles; ++i) {
        const std::string name = names[i];
        if (const auto bytes = stored_bytes(mount_ + "/" + name)) members.push_back({name, *bytes});
      }
    }
    if (auto checked = check(members); !checked) return tl::unexpected(checked.error());
    std::sort(members.begin(), members.end(),
              [](const Member& p, const Member& q) { return p.name < q.name; });
    return members;
  }

  // Into memory, so that nothing is left on disk whatever happens.
  Result<std::string> unpack(const Member& member) const {
    const GdalMessages messages;
    const std::string target = kUnpackedRoot + member.name;
    const std::string from = is_single_file() ? mount_ : mount_ + "/" + member.name;
    auto* in = VSIFOpenL(from.c_str(), "rb");
    auto* out = VSIFOpenL(target.c_str(), "wb");
    const bool complete = in != nullptr && out != nullptr && copy(in, out, member.bytes);
    if (in != nullptr) VSIFCloseL(in);
    if (out != nullptr) VSIFCloseL(out);
    if (complete) return target;
    return input_failure(path_ + ": " + member.name +
                         " in it cannot be unpacked: the archive is damaged, locked by a password, "
                         "or packed in a way that is not known here; unpack it first");
  }

  const std::string& path() const { return path_; }

 private:
  bool is_single_file() const { return mount_.starts_with("/vsigzip/"); }

  Result<void> check(const std::vector<Member>& members) const {
    std::uint64_t bytes = 0;
    for (const auto& member : members) {
      if (leaves_the_archive(member.name)) {
        return input_failure(path_ + ": holds a file '" + member.name +
                             "' that would be unpacked outside of it: it is not to be trusted");
      }
      bytes += member.bytes;
    }
    if (members.size() > kMostFiles || bytes > kMostBytes) {
      return input_failure(path_ +
                           ": unpacks to more than 1 GiB or 10,000 files: unpack it first "
                           "and give what is needed");
    }
    return {};
  }

  // A member that goes on behind the size it declares is no honest one.
  static bool copy(VSILFILE* in, VSILFILE* out, std::uint64_t declared) {
    std::vector<char> buffer(1 << 18U);
    std::uint64_t total = 0;
    while (true) {
      const auto size = VSIFReadL(buffer.data(), 1, buffer.size(), in);
      total += size;
      if (total > kMostBytes || VSIFWriteL(buffer.data(), 1, size, out) != size) return false;
      if (size < buffer.size()) return declared == 0 || total == declared;
    }
  }

  std::string path_;
  std::string mount_;
};

// Several readers as one: layer after layer.
class ArchiveReader : public SourceReader {
 public:
  explicit ArchiveReader(std::string path) : path_(std::move(path)) {}

  void add(std::unique_ptr<SourceReader> reader) {
    for (std::size_t i = 0; i < reader->layers().size(); ++i) {
      layers_.push_back(reader->layers()[i]);
      places_.push_back({readers_.size(), i});
    }
    for (auto& warning : reader->take_warnings()) warn(warning);
    driver_ = readers_.empty() || driver_ == reader->driver() ? reader->driver() : "archive";
    readers_.push_back(std::move(reader));
  }
  void warn(const std::string& warning) { warnings_.push_back(renamed(warning)); }

  // People know the archive, not where it was unpacked to.
  std::string renamed(std::string text) const {
    const std::string root = kUnpackedRoot;
    for (auto at = text.find(root); at != text.npos; at = text.find(root)) {
      text.replace(at, root.size(), path_ + "/");
    }
    return text;
  }
  Failure renamed(const Failure& failure) const { return {failure.kind, renamed(failure.message)}; }

  const std::string& driver() const override { return driver_; }
  const std::vector<LayerInfo>& layers() const override { return layers_; }
  std::vector<std::string> take_warnings() override { return std::exchange(warnings_, {}); }

  Result<std::optional<Box>> extent(std::size_t layer) override {
    auto box = readers_[places_[layer].reader]->extent(places_[layer].layer);
    if (!box) return tl::unexpected(renamed(box.error()));
    return box;
  }

  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    auto& reader = *readers_[places_[layer].reader];
    const auto count = reader.read(places_[layer].layer, options, visit);
    for (auto& warning : reader.take_warnings()) warn(warning);
    if (!count) return tl::unexpected(renamed(count.error()));
    return *count;
  }

 private:
  struct Place {
    std::size_t reader = 0;
    std::size_t layer = 0;
  };
  std::string path_;
  std::vector<std::unique_ptr<SourceReader>> readers_;
  std::vector<Place> places_;
  std::vector<LayerInfo> layers_;
  std::string driver_;
  std::vector<std::string> warnings_;
};

std::string holds_nothing(const std::string& path, const std::vector<Member>& members) {
  std::string names;
  for (std::size_t i = 0; i < members.size() && i < 5; ++i) {
    names += (i == 0 ? "" : ", ") + members[i].name;
  }
  if (members.size() > 5) names += " …";
  return path + ": holds no GIS file" +
         (names.empty() ? ": it is empty or damaged" : ", only " + names);
}

}  // namespace

bool is_archive(const std::string& path) {
  return !mounted(path).empty();
}

std::uint64_t unpacked_bytes(const std::string& path) {
  const auto members = Archive(path).members();
  std::uint64_t bytes = 0;
  if (members) {
    for (const auto& member : *members) bytes += member.bytes;
  }
  return std::max(bytes, stored_bytes(path).value_or(0));
}

OpenedReader open_archive(const std::string& path, const std::vector<std::string>& drivers,
                          const DriverNotice& notice) {
  const Archive archive(path);
  const auto members = archive.members();
  if (!members) return tl::unexpected(members.error());
  auto reader = std::make_unique<ArchiveReader>(path);
  std::vector<std::string> datasets;
  for (const auto& member : *members) {
    if (is_litter(member.name)) continue;
    if (!is_dataset(member.name) && !is_companion(member.name)) {
      reader->warn(path + ": " + member.name + " in it is not read");
      continue;
    }
    auto unpacked = archive.unpack(member);
    if (!unpacked) return tl::unexpected(unpacked.error());
    if (is_dataset(member.name)) datasets.push_back(*unpacked);
  }
  for (const auto& dataset : datasets) {
    const GdalInput input{dataset, reader->renamed(dataset), {}, drivers};
    auto opened = open_single(input, notice);
    if (!opened) return tl::unexpected(reader->renamed(opened.error()));
    reader->add(*std::move(opened));
  }
  if (datasets.empty()) return input_failure(holds_nothing(path, *members));
  return reader;
}

}  // namespace mapwright::converter
