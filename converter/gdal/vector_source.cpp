#include "converter/gdal/vector_source.hpp"

#include <filesystem>

#include "converter/gdal/archive.hpp"
#include "converter/gdal/drivers.hpp"
#include "converter/gdal/gdal_reader.hpp"
#include "converter/gdal/private_copy.hpp"
#include "converter/gdal/shapefile_index.hpp"
#include "converter/gdal/single_source.hpp"
#include "converter/isolation/isolated_reader.hpp"
#include "converter/osm/osm_reader.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

// GDAL takes many texts for names of data sets; a source is a file or folder of this machine.
Result<void> check_path(const std::string& path) {
  if (path.find("/vsi") != path.npos || path.find("://") != path.npos) {
    return usage_failure(path +
                         ": is no local file or folder: remote and virtual sources are refused; "
                         "fetch or unpack it first");
  }
  std::error_code error;
  if (!fs::exists(path, error)) return input_failure(path + ": there is no such file or folder");
  if (fs::is_directory(path, error)) {
    fs::directory_iterator entries(path, error);
    if (error) return input_failure(path + ": cannot be read: " + error.message());
    if (entries == fs::directory_iterator()) return input_failure(path + ": the folder is empty");
    return {};
  }
  if (!fs::is_regular_file(path, error)) {
    return input_failure(
        path + ": is a pipe or a device: sources are files, which are read more than once");
  }
  const auto size = fs::file_size(path, error);
  if (error) return input_failure(path + ": cannot be read: " + error.message());
  if (size == 0) return input_failure(path + ": the file is empty");
  return {};
}

// The parts of a data set lie beside it, so that a folder's bytes are what may have to be read.
std::uint64_t bytes_to_read(const std::string& path) {
  if (is_archive(path)) return unpacked_bytes(path);
  std::error_code error;
  const fs::path folder =
      fs::is_directory(path, error) ? fs::path(path) : fs::path(path).parent_path();
  const std::string stem = fs::path(path).stem().string();
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const bool part = folder == path || entry.path().stem().string() == stem;
    if (part && entry.is_regular_file(error)) bytes += entry.file_size(error);
  }
  return bytes;
}

OpenedReader open_by_format(const GdalInput& input, const DriverNotice& notice) {
  const bool archive = is_archive(input.path) && !is_osm(input.path);  // OSM may be gzipped
  if (archive) return open_archive(input.path, input.drivers, notice);
  return open_single(input, notice);
}

}  // namespace

struct VectorSource::Impl {
  std::string path;
  std::unique_ptr<PrivateFolder> folder;  // outlives the reader, which may read there
  std::unique_ptr<SourceReader> reader;
  std::vector<std::string> warnings;

  void collect_warnings() {
    for (auto& warning : reader->take_warnings()) warnings.push_back(std::move(warning));
  }
};

VectorSource::VectorSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VectorSource::VectorSource(VectorSource&&) noexcept = default;
VectorSource& VectorSource::operator=(VectorSource&&) noexcept = default;
VectorSource::~VectorSource() = default;

const std::string& VectorSource::path() const {
  return impl_->path;
}
const std::string& VectorSource::driver() const {
  return impl_->reader->driver();
}
const std::vector<LayerInfo>& VectorSource::layers() const {
  return impl_->reader->layers();
}
const std::vector<std::string>& VectorSource::warnings() const {
  return impl_->warnings;
}

Result<VectorSource> VectorSource::open(const std::string& path, const OpenOptions& options) {
  if (auto checked = check_path(path); !checked) return tl::unexpected(checked.error());
  const auto drivers = allow_drivers(options.extra_drivers);
  if (!drivers) return tl::unexpected(drivers.error());
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  GdalInput input{path, path, {}, *drivers};
  if (reading_leaves_traces(path) || wants_index(path)) {
    auto folder = PrivateFolder::create();
    if (!folder) return tl::unexpected(folder.error());
    impl->folder = *std::move(folder);
    input.folder = impl->folder->path().string();
  }
  auto reader = open_isolated(path, bytes_to_read(path), [&input](const DriverNotice& notice) {
    return open_by_format(input, notice);
  });
  if (!reader) return tl::unexpected(reader.error());
  impl->reader = *std::move(reader);
  impl->collect_warnings();
  return VectorSource(std::move(impl));
}

Result<std::optional<Box>> VectorSource::extent(std::size_t layer) {
  return impl_->reader->extent(layer);
}

Result<std::size_t> VectorSource::read(std::size_t layer, const ReadOptions& options,
                                       const FeatureVisitor& visit) {
  auto count = impl_->reader->read(layer, options, visit);
  impl_->collect_warnings();
  return count;
}

}  // namespace mapwright::converter
