#include "converter/gdal/column_reader.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_version.h>
#include <ogrsf_frmts.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "converter/gdal/messages.hpp"
#include "mapcore/text/byte_counts.hpp"

#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 6, 0)
#include <ogr_recordbatch.h>

namespace mapwright::converter {
namespace {

// Enough that a batch's query costs nothing, few enough that a batch of large geometries fits.
constexpr const char* kRowsInBatch = "MAX_FEATURES_IN_BATCH=1024";

// The worker that GDAL would start to read ahead opens the file a second time.
class OneThread {
 public:
  OneThread() { CPLSetThreadLocalConfigOption("GDAL_NUM_THREADS", "1"); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
  ~OneThread() { CPLSetThreadLocalConfigOption("GDAL_NUM_THREADS", nullptr); }
};

enum class Content { kNothing, kInt32, kInt64, kDouble, kText };

// Types whose columns hold what OGRFeature's getters give.
Content content_of(const OGRFieldDefn& field) {
  if (field.IsIgnored()) return Content::kNothing;
  switch (field.GetType()) {
    case OFTInteger:
      return field.GetSubType() == OFSTNone ? Content::kInt32 : Content::kNothing;
    case OFTInteger64:
      return Content::kInt64;
    case OFTReal:
      return field.GetSubType() == OFSTNone ? Content::kDouble : Content::kNothing;
    case OFTString:
      return Content::kText;
    default:
      return Content::kNothing;
  }
}

std::string_view format_of(Content content) {
  switch (content) {
    case Content::kInt32:
      return "i";
    case Content::kInt64:
      return "l";
    case Content::kDouble:
      return "g";
    case Content::kText:
      return "u";
    case Content::kNothing:
      break;
  }
  return "";
}

// Nothing where a field is read whose columns are not its values.
bool columns_of(OGRFeatureDefn& definition, std::vector<Content>& contents, FeatureRow& row) {
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    const auto& field = *definition.GetFieldDefn(i);
    if (field.IsIgnored()) continue;
    const auto content = content_of(field);
    if (content == Content::kNothing) return false;
    contents.push_back(content);
    row.fields.push_back(static_cast<std::uint32_t>(i));
  }
  row.values.resize(contents.size());
  return definition.GetGeomFieldCount() == 1 && !definition.GetGeomFieldDefn(0)->IsIgnored();
}

// Ids, the fields, the geometry: as documented for GetArrowStream.
bool is_as_expected(const ArrowSchema& schema, const std::vector<Content>& contents) {
  if (schema.n_children != static_cast<std::int64_t>(contents.size()) + 2) return false;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    if (schema.children[i + 1]->format != format_of(contents[i])) return false;
  }
  return std::string_view(schema.children[0]->format) == "l" &&
         std::string_view(schema.children[schema.n_children - 1]->format) == "z";
}

bool is_null(const ArrowArray& array, std::size_t row) {
  const auto* valid = static_cast<const std::uint8_t*>(array.buffers[0]);
  return array.null_count != 0 && valid != nullptr && (valid[row / 8] >> (row % 8) & 1U) == 0;
}

template <class T>
T value_at(const ArrowArray& array, std::size_t row) {
  return static_cast<const T*>(array.buffers[1])[row];
}

std::span<const char> bytes_at(const ArrowArray& array, std::size_t row) {
  const auto* offsets = static_cast<const std::int32_t*>(array.buffers[1]);
  const auto* bytes = static_cast<const char*>(array.buffers[2]);
  return {bytes + offsets[row], static_cast<std::size_t>(offsets[row + 1] - offsets[row])};
}

bool read_text(std::span<const char> bytes, RowValue& value) {
  const std::string_view text(bytes.data(), bytes.size());
  value = text;
  return text::is_printable_ascii(text) ||
         CPLIsUTF8(text.data(), static_cast<int>(text.size())) != 0;
}

bool read_value(const ArrowArray& array, std::size_t row, Content content, RowValue& value) {
  if (is_null(array, row)) {
    value = std::monostate();
    return true;
  }
  switch (content) {
    case Content::kInt32:
      value = std::int64_t{value_at<std::int32_t>(array, row)};
      return true;
    case Content::kInt64:
      value = value_at<std::int64_t>(array, row);
      return true;
    case Content::kDouble:
      value = value_at<double>(array, row);
      return true;
    default:
      return read_text(bytes_at(array, row), value);
  }
}

}  // namespace

struct ColumnReader::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    release_batch();
    if (stream.release != nullptr) stream.release(&stream);
  }

  void release_batch() {
    if (batch.release != nullptr) batch.release(&batch);
    batch.release = nullptr;
  }

  // What GDAL says of errors here it says again when the rows are read as features.
  bool next_batch() {
    const GdalMessages unheard;
    const OneThread one;
    release_batch();
    at = 0;
    const int error = stream.get_next(&stream, &batch);
    gave_up = error != 0 || unheard.has_error();
    return !gave_up && batch.release != nullptr;
  }

  // Ids ascend, for rows come as the table has them. GDAL 3.6 hands the last row out again where
  // rows are fewer than the count that the database keeps of them.
  bool read() {
    const auto* ids = batch.children[0];
    const auto* geometries = batch.children[batch.n_children - 1];
    if (is_null(*ids, at) || is_null(*geometries, at)) return false;
    row.fid = value_at<std::int64_t>(*ids, at);
    if (last_id && row.fid <= *last_id) return false;
    last_id = row.fid;
    for (std::size_t i = 0; i < contents.size(); ++i) {
      if (!read_value(*batch.children[i + 1], at, contents[i], row.values[i])) return false;
    }
    return find_paths(std::as_bytes(bytes_at(*geometries, at)), row.geometry);
  }

  ArrowArrayStream stream{};
  ArrowArray batch{};
  std::vector<Content> contents;  // of the fields that are read
  FeatureRow row;
  std::size_t at = 0;  // the row's number in the batch
  std::optional<std::int64_t> last_id;
  bool gave_up = false;
};

ColumnReader::ColumnReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ColumnReader::~ColumnReader() = default;

std::unique_ptr<ColumnReader> ColumnReader::open(OGRLayer& layer) {
  const GdalMessages unheard;
  const OneThread one;
  auto impl = std::make_unique<Impl>();
  auto& definition = *layer.GetLayerDefn();
  const bool has_ids = layer.GetFIDColumn()[0] != '\0';
  if (!has_ids || !columns_of(definition, impl->contents, impl->row)) return nullptr;
  CPLStringList options;
  options.AddString(kRowsInBatch);
  if (!layer.GetArrowStream(&impl->stream, options.List())) return nullptr;
  ArrowSchema schema{};
  if (impl->stream.get_schema(&impl->stream, &schema) != 0) return nullptr;
  const bool fits = is_as_expected(schema, impl->contents);
  schema.release(&schema);
  return fits ? std::unique_ptr<ColumnReader>(new ColumnReader(std::move(impl))) : nullptr;
}

const FeatureRow* ColumnReader::next() {
  auto& impl = *impl_;
  while (impl.batch.release == nullptr || impl.at == static_cast<std::size_t>(impl.batch.length)) {
    if (impl.gave_up || !impl.next_batch()) return nullptr;
  }
  impl.gave_up = !impl.read();
  ++impl.at;
  return impl.gave_up ? nullptr : &impl.row;
}

bool ColumnReader::gave_up() const {
  return impl_->gave_up;
}

}  // namespace mapwright::converter

#else

namespace mapwright::converter {

struct ColumnReader::Impl {};

ColumnReader::ColumnReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ColumnReader::~ColumnReader() = default;
std::unique_ptr<ColumnReader> ColumnReader::open(OGRLayer&) {
  return nullptr;
}
const FeatureRow* ColumnReader::next() {
  return nullptr;
}
bool ColumnReader::gave_up() const {
  return true;
}

}  // namespace mapwright::converter

#endif
